use winnow::ascii::{float, multispace0};
use winnow::combinator::{cut_err, eof, opt, peek};
use winnow::error::{ContextError, ErrMode};
use winnow::prelude::*;
use winnow::stream::{LocatingSlice, Location, Stateful};
use winnow::token::{any, one_of, take_while};

use crate::dynamics::formula::{Expression, FormulaError, Function, Operator, Variable};

type Input<'text> = Stateful<LocatingSlice<&'text str>, Progress>;

/// What is bounded, and what was found wrong.
#[derive(Debug, Default)]
struct Progress {
    depth: usize,
    size: usize,
    /// The byte where the rule is broken, and the rule.
    broken: Option<(usize, String)>,
}

pub fn read(text: &str) -> Result<Expression, FormulaError> {
    let mut input = Input { input: LocatingSlice::new(text), state: Progress::default() };
    let mut whole = |input: &mut Input<'_>| -> ModalResult<Expression> {
        multispace0.parse_next(input)?;
        let found = sum(input)?;
        eof.parse_next(input)?;
        Ok(found)
    };
    whole.parse_next(&mut input).map_err(|_: ErrMode<ContextError>| {
        let here = input.input.current_token_start();
        let expected = || (here, "here stands what no formula goes on with".to_owned());
        let (byte, rule) = input.state.broken.take().unwrap_or_else(expected);
        FormulaError { column: text.get(..byte).unwrap_or(text).chars().count() + 1, rule }
    })
}

/// Refuses what stands at a byte.
fn refuse<T>(input: &mut Input<'_>, byte: usize, rule: String) -> ModalResult<T> {
    input.state.broken = Some((byte, rule));
    Err(ErrMode::Cut(ContextError::new()))
}

/// One more number, name or operation.
fn grow(input: &mut Input<'_>) -> ModalResult<()> {
    input.state.size += 1;
    if input.state.size > Expression::LARGEST {
        let here = input.input.current_token_start();
        return refuse(input, here, format!("more than {} numbers, names and operations", Expression::LARGEST));
    }
    Ok(())
}

/// One level deeper.
fn within(
    input: &mut Input<'_>,
    parser: impl FnOnce(&mut Input<'_>) -> ModalResult<Expression>,
) -> ModalResult<Expression> {
    input.state.depth += 1;
    if input.state.depth > Expression::DEEPEST {
        let here = input.input.current_token_start();
        return refuse(
            input,
            here,
            format!("more than {} brackets, signs and powers within each other", Expression::DEEPEST),
        );
    }
    let found = parser(input)?;
    input.state.depth -= 1;
    Ok(found)
}

/// One of these characters, and the space after it.
fn sign<const N: usize>(input: &mut Input<'_>, signs: [char; N]) -> ModalResult<Option<char>> {
    let found = opt(one_of(signs)).parse_next(input)?;
    multispace0.parse_next(input)?;
    Ok(found)
}

/// An operand that must come.
fn operand(
    input: &mut Input<'_>,
    parser: fn(&mut Input<'_>) -> ModalResult<Expression>,
) -> ModalResult<Box<Expression>> {
    grow(input)?;
    cut_err(parser).parse_next(input).map(Box::new)
}

fn sum(input: &mut Input<'_>) -> ModalResult<Expression> {
    let mut left = product(input)?;
    while let Some(found) = sign(input, ['+', '-'])? {
        let operator = if found == '+' { Operator::Plus } else { Operator::Minus };
        left = Expression::Operation(operator, Box::new(left), operand(input, product)?);
    }
    Ok(left)
}

fn product(input: &mut Input<'_>) -> ModalResult<Expression> {
    let mut left = signed(input)?;
    while let Some(found) = sign(input, ['*', '/'])? {
        let operator = if found == '*' { Operator::Times } else { Operator::Over };
        left = Expression::Operation(operator, Box::new(left), operand(input, signed)?);
    }
    Ok(left)
}

fn signed(input: &mut Input<'_>) -> ModalResult<Expression> {
    match sign(input, ['+', '-'])? {
        None => power(input),
        Some('+') => within(input, signed),
        Some(_) => {
            grow(input)?;
            within(input, signed).map(|value| Expression::Negative(Box::new(value)))
        }
    }
}

fn power(input: &mut Input<'_>) -> ModalResult<Expression> {
    let base = atom(input)?;
    if sign(input, ['^'])?.is_none() {
        return Ok(base);
    }
    grow(input)?;
    let exponent = within(input, signed)?;
    Ok(Expression::Operation(Operator::Power, Box::new(base), Box::new(exponent)))
}

fn atom(input: &mut Input<'_>) -> ModalResult<Expression> {
    grow(input)?;
    let start = input.input.current_token_start();
    let Ok(first) = peek(any::<_, ErrMode<ContextError>>).parse_next(input) else {
        return refuse(input, start, "the formula ends where a number, a name or a bracket must come".to_owned());
    };
    match first {
        '(' => {
            any.parse_next(input)?;
            multispace0.parse_next(input)?;
            let value = within(input, sum)?;
            close(input)?;
            Ok(value)
        }
        '0'..='9' | '.' => {
            let Ok(value) = float::<_, f64, ErrMode<ContextError>>.parse_next(input) else {
                return refuse(input, start, "no number is written so".to_owned());
            };
            multispace0.parse_next(input)?;
            if value.is_finite() {
                Ok(Expression::Number(value))
            } else {
                refuse(input, start, "the number is beyond f64".to_owned())
            }
        }
        letter if letter.is_alphabetic() || letter == '_' => named(input, start),
        _ => refuse(input, start, format!("{first:?} begins no number, name or bracket")),
    }
}

fn close(input: &mut Input<'_>) -> ModalResult<()> {
    if sign(input, [')'])?.is_some() {
        return Ok(());
    }
    let here = input.input.current_token_start();
    refuse(input, here, "here a bracket must be closed".to_owned())
}

fn named(input: &mut Input<'_>, start: usize) -> ModalResult<Expression> {
    let name = take_while(1.., |letter: char| letter.is_alphanumeric() || letter == '_').parse_next(input)?;
    multispace0.parse_next(input)?;
    if sign(input, ['('])?.is_some() {
        let Some(function) = Function::from_name(name) else {
            let known = Function::ALL.map(|(name, _)| name).join(", ");
            return refuse(input, start, format!("{name:?} is no function; known are {known}"));
        };
        return called(input, start, name, function);
    }
    if name == "pi" {
        return Ok(Expression::Number(std::f64::consts::PI));
    }
    match Variable::from_name(name) {
        Some(variable) => Ok(Expression::Variable(variable)),
        None if Function::from_name(name).is_some() => {
            refuse(input, start, format!("{name:?} is a function: it needs its values in brackets"))
        }
        None => {
            let known = Variable::ALL.map(|(name, _)| name).join(", ");
            refuse(input, start, format!("{name:?} is no variable; known are {known}, pi"))
        }
    }
}

fn called(input: &mut Input<'_>, start: usize, name: &str, function: Function) -> ModalResult<Expression> {
    let mut arguments = vec![within(input, sum)?];
    while sign(input, [','])?.is_some() {
        arguments.push(within(input, sum)?);
    }
    close(input)?;
    let (wanted, given) = (function.arguments(), arguments.len());
    if wanted == given {
        return Ok(Expression::Call(function, arguments));
    }
    refuse(input, start, format!("{name} takes {wanted} values, not {given}"))
}
