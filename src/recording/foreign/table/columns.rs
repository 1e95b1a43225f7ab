/// The columns that a mapping names, each read once however often it is named.
#[derive(Debug)]
pub(in crate::recording) struct Columns<'a> {
    /// What the columns are called; empty if they are not.
    names: &'a [String],
    /// How many there are.
    count: usize,
    /// That of time, if it is one of them.
    time: Option<usize>,
    /// Of the others those that are named, by their places from 0.
    places: Vec<usize>,
}

impl<'a> Columns<'a> {
    pub fn new(names: &'a [String], count: usize) -> Self {
        Self { names, count, time: None, places: Vec::new() }
    }

    /// Finds the place of the column of time.
    ///
    /// # Errors
    /// If there is none of that name or number, or several.
    pub fn find_time(&mut self, name: &str) -> Result<usize, String> {
        let place = self.place(name).map_err(|reason| format!("time names {name:?}: {reason}"))?;
        self.time = Some(place);
        Ok(place)
    }

    pub fn places(&self) -> &[usize] {
        &self.places
    }

    /// The number of a column among those to be read.
    fn find(&mut self, key: &str, name: &str) -> Result<usize, String> {
        let place = self.place(name).map_err(|reason| format!("{key} names {name:?}: {reason}"))?;
        if self.time == Some(place) {
            return Err(format!("{key} names {name:?}: that is the column of time"));
        }
        if let Some(known) = self.places.iter().position(|known| *known == place) {
            return Ok(known);
        }
        self.places.push(place);
        Ok(self.places.len() - 1)
    }

    /// The numbers of several columns among those to be read.
    ///
    /// # Errors
    /// If there is none of one's name or number, or several, or it is that of time.
    pub fn find_all<const N: usize>(&mut self, key: &str, names: &[String; N]) -> Result<[usize; N], String> {
        let mut numbers = [0; N];
        for (number, name) in numbers.iter_mut().zip(names) {
            *number = self.find(key, name)?;
        }
        Ok(numbers)
    }

    fn place(&self, name: &str) -> Result<usize, String> {
        let mut named = self.names.iter().enumerate().filter(|(_, known)| *known == name);
        match (named.next(), named.next()) {
            (Some((place, _)), None) => return Ok(place),
            (Some(_), Some(_)) => return Err("there are several of that name".into()),
            _ => {}
        }
        let count = self.count;
        match name.parse::<usize>() {
            Ok(number) if (1..=count).contains(&number) => Ok(number - 1),
            Ok(_) => Err(format!("the columns are 1 to {count}")),
            Err(_) if self.names.is_empty() => Err(format!("no line names the columns: they are 1 to {count}")),
            Err(_) => Err(format!("the columns are {}", shortened(self.names))),
        }
    }
}

/// Names in a row, as many as one reads.
fn shortened(names: &[String]) -> String {
    const MOST: usize = 24;
    let mut text = names.iter().take(MOST).map(String::as_str).collect::<Vec<_>>().join(", ");
    if names.len() > MOST {
        text += ", …";
    }
    text
}
