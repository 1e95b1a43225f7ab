use super::head::Head;

/// The columns that a mapping names, each read once however often it is named.
#[derive(Debug)]
pub(super) struct Columns<'a> {
    head: &'a Head,
    /// Their places in a line, from 0.
    places: Vec<usize>,
}

impl<'a> Columns<'a> {
    pub fn new(head: &'a Head) -> Self {
        Self { head, places: Vec::new() }
    }

    pub fn places(&self) -> &[usize] {
        &self.places
    }

    /// The number of a column among those to be read.
    ///
    /// # Errors
    /// If there is none of that name or number, or several.
    pub fn find(&mut self, key: &str, name: &str) -> Result<usize, String> {
        let place = self.place(name).map_err(|reason| format!("{key} names {name:?}: {reason}"))?;
        if let Some(known) = self.places.iter().position(|known| *known == place) {
            return Ok(known);
        }
        self.places.push(place);
        Ok(self.places.len() - 1)
    }

    /// The numbers of several.
    pub fn find_all<const N: usize>(&mut self, key: &str, names: &[String; N]) -> Result<[usize; N], String> {
        let mut numbers = [0; N];
        for (number, name) in numbers.iter_mut().zip(names) {
            *number = self.find(key, name)?;
        }
        Ok(numbers)
    }

    fn place(&self, name: &str) -> Result<usize, String> {
        let mut named = self.head.names.iter().enumerate().filter(|(_, known)| *known == name);
        match (named.next(), named.next()) {
            (Some((place, _)), None) => return Ok(place),
            (Some(_), Some(_)) => return Err("there are several of that name".into()),
            _ => {}
        }
        let count = self.head.columns;
        match name.parse::<usize>() {
            Ok(number) if (1..=count).contains(&number) => Ok(number - 1),
            Ok(_) => Err(format!("the columns are 1 to {count}")),
            Err(_) if self.head.names.is_empty() => Err(format!("no line names the columns: they are 1 to {count}")),
            Err(_) => Err(format!("the columns are {}", shortened(&self.head.names))),
        }
    }
}

/// Names in a row, as many as one reads.
pub(super) fn shortened(names: &[String]) -> String {
    const MOST: usize = 24;
    let mut text = names.iter().take(MOST).map(String::as_str).collect::<Vec<_>>().join(", ");
    if names.len() > MOST {
        text += ", …";
    }
    text
}
