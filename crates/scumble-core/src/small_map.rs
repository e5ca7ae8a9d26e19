//! A map with few keys, as a sorted list. The standard library's tree has some 3 KB of code for each type of value.

/// Values by key, in ascending order of keys.
#[derive(Clone, Debug, Default)]
pub(crate) struct SmallMap<T>(Vec<(u32, T)>);

impl<T: Default> SmallMap<T> {
    /// The value of a key; the default one is put in where there is none.
    pub(crate) fn entry(&mut self, key: u32) -> &mut T {
        let place = self.0.binary_search_by_key(&key, |(key, _)| *key).unwrap_or_else(|place| {
            self.0.insert(place, (key, T::default()));
            place
        });
        &mut self.0[place].1
    }

    /// The value of a key that there is.
    pub(crate) fn get_mut(&mut self, key: u32) -> Option<&mut T> {
        let place = self.0.binary_search_by_key(&key, |(key, _)| *key).ok()?;
        Some(&mut self.0[place].1)
    }

    /// All keys and values.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &(u32, T)> {
        self.0.iter()
    }

    /// All values.
    pub(crate) fn values(&self) -> impl Iterator<Item = &T> {
        self.0.iter().map(|(_, value)| value)
    }

    /// All values, to be changed.
    pub(crate) fn values_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.0.iter_mut().map(|(_, value)| value)
    }
}
