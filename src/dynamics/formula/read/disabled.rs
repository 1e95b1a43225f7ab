use crate::dynamics::formula::{Expression, FormulaError};

pub fn read(_: &str) -> Result<Expression, FormulaError> {
    Err(FormulaError { column: 1, rule: "this build reads no formulae: its feature \"serde\" is off".to_owned() })
}
