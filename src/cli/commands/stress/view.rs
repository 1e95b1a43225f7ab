use crate::cli::args::Shown;
use crate::comparison::{Growth, Law};
use crate::scenario::Setting;
use crate::study::{Cell, Drift, Row, Trial, Truth, Verdict};

impl Shown {
    /// What a matrix of it shows, as its first line.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Attitude => "right digits of the attitude at the best of the settings",
            Self::Energy => "right digits of the energy in the same run, and its growth law",
            Self::Momentum => "right digits of the angular momentum in the same run, and its growth law",
            Self::Breaks => "the most steps to a turn with which the motion is lost",
            Self::Lasts => "after how many turns it is lost, with so many steps",
        }
    }

    /// What each sign means, below the matrix.
    pub const fn legend(self) -> &'static str {
        match self {
            Self::Attitude => {
                "\
A number: right digits of the attitude at its best, −log₁₀ of the error in rad
  =  within its limit: as right as f64 and the motion allow, or as promised
  ~  follows the motion, but less exactly than f64 allows
  c  chaotic: the motion itself magnifies one rounding past 0.1 rad
  x  loses the motion (0.1 rad), or ends with an error on the way
  !! must never be given: beyond its promise, not finite without an error,
     not of unit length, or with a jump of the quaternion's sign
  –  refused before the run, with a reason
  .  would take too many steps
  ?  nothing to measure it by
"
            }
            Self::Energy | Self::Momentum => {
                "\
A number: −log₁₀ of its largest relative error; then how that grows
  b  bounded   r  as √t   t  as t   p  as a higher power of t   e  exponential
  i  by no simple law; no letter: too little to tell a law
  ·  not conserved, or not run
"
            }
            Self::Breaks => {
                "\
A number: the finest step that loses the motion (0.1 rad), in steps to a turn
  ·  every step tried follows it, or none was tried
"
            }
            Self::Lasts => {
                "\
A number: turns of the fastest rate until the run with that step is 0.1 rad off
  ·  every step tried follows it, or none was tried
"
            }
        }
    }

    /// Of one cell, three letters at most.
    pub fn sign(self, row: &Row, cell: &Cell) -> String {
        // In the middle, so that a number of three letters beside it reads as one.
        let nothing = || "· ".to_owned();
        let drift = |of: fn(&Trial) -> Option<&Drift>| {
            let is_run = matches!(cell.verdict, Verdict::Kept | Verdict::Coarse | Verdict::Chaotic | Verdict::Lost);
            cell.best().filter(|_| is_run).and_then(of).map_or_else(nothing, in_letters)
        };
        let turn = row.truth.as_ref().map_or(1.0, Truth::turn_s);
        let is_stepped = cell.method.setting() == Setting::Step;
        let broken = cell.broken().filter(|_| is_stepped);
        match self {
            Self::Attitude => cell.sign(),
            Self::Energy => drift(|trial| trial.energy.as_ref()),
            Self::Momentum => drift(|trial| trial.momentum.as_ref()),
            Self::Breaks => broken.and_then(|trial| trial.value).map_or_else(nothing, |step| count(turn / step)),
            Self::Lasts => broken.and_then(|trial| trial.lost_at_s).map_or_else(nothing, |time| count(time / turn)),
        }
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within 0 to 16")]
fn in_letters(drift: &Drift) -> String {
    let digits = (-libm::log10(drift.largest.max(1e-16))).floor().max(0.0) as u32;
    format!("{digits}{}", drift.growth.as_ref().map_or("", letter))
}

/// t^½ and t are told apart at the powers between them.
fn letter(growth: &Growth) -> &'static str {
    match growth.law {
        Law::Bounded => "b",
        Law::Power { exponent } if exponent < 0.75 => "r",
        Law::Power { exponent } if exponent < 1.5 => "t",
        Law::Power { .. } => "p",
        Law::Exponential { .. } => "e",
        Law::Irregular => "i",
    }
}

/// In three letters: 0.4, 12, 128, 4k, .2M, 16M.
fn count(value: f64) -> String {
    if value < 9.95 && (value - value.round()).abs() > 0.05 {
        format!("{value:.1}")
    } else if value < 999.5 {
        format!("{value:.0}")
    } else if value < 99.5e3 {
        format!("{:.0}k", value / 1e3)
    } else if value < 0.95e6 {
        format!("{:.1}M", value / 1e6).trim_start_matches('0').to_owned()
    } else {
        format!("{:.0}M", (value / 1e6).min(99.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_have_three_letters() {
        let counts = [0.42, 3.0, 12.3, 128.0, 4096.0, 99_400.0, 250_000.0, 16e6, 1e9];
        assert_eq!(counts.map(count), ["0.4", "3", "12", "128", "4k", "99k", ".2M", "16M", "99M"]);
    }

    #[test]
    fn titles_and_legends_fit_into_eighty_columns() {
        for shown in [Shown::Attitude, Shown::Energy, Shown::Momentum, Shown::Breaks, Shown::Lasts] {
            // Of the title, `quick: ` comes before it.
            assert!(shown.title().chars().count() <= 73, "{shown:?}");
            assert!(shown.legend().lines().all(|line| line.chars().count() <= 80), "{shown:?}");
        }
    }
}
