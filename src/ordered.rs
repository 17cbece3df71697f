//! JSON whose objects keep the order in which they were filled, whichever features of `serde_json` a host has on.

use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::Value;

/// A JSON value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Json {
    /// Anything but an object, or one whose order does not matter.
    Value(Value),
    /// Each key once, in this order.
    Object(Vec<(String, Json)>),
    /// A list that may hold objects.
    List(Vec<Json>),
}

impl Json {
    /// An object with these pairs.
    pub(crate) fn object<const N: usize>(pairs: [(&str, Json); N]) -> Self {
        Self::Object(pairs.into_iter().map(|(key, value)| (key.to_owned(), value)).collect())
    }

    /// Puts a pair into an object, in the place of its key where that is known. Does nothing to what is no object.
    pub(crate) fn set(&mut self, key: &str, value: impl Into<Json>) {
        if let Some(place) = self.entry(key) {
            *place = value.into();
        }
    }

    /// The value of `key` in an object, an empty object where it had none; none in what is no object.
    pub(crate) fn entry(&mut self, key: &str) -> Option<&mut Json> {
        let Self::Object(pairs) = self else { return None };
        let at = pairs.iter().position(|(known, _)| known == key).unwrap_or_else(|| {
            pairs.push((key.to_owned(), Self::Object(Vec::new())));
            pairs.len() - 1
        });
        Some(&mut pairs[at].1)
    }

    /// As text, indented, with a line break at its end.
    pub(crate) fn pretty(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n" // its keys are strings: nothing can fail
    }
}

impl<T: Into<Value>> From<T> for Json {
    fn from(value: T) -> Self {
        Self::Value(value.into())
    }
}

impl Serialize for Json {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Value(value) => value.serialize(serializer),
            Self::List(items) => items.serialize(serializer),
            Self::Object(pairs) => {
                let mut map = serializer.serialize_map(Some(pairs.len()))?;
                pairs.iter().try_for_each(|(key, value)| map.serialize_entry(key, value))?;
                map.end()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_stay_in_the_order_in_which_they_came() {
        let mut json = Json::object([("z", 1.into()), ("a", Json::List(vec![Json::object([])]))]);
        json.set("z", 2);
        json.set("m", "last");
        let text: String = json.pretty().split_whitespace().collect();
        assert_eq!(text, r#"{"z":2,"a":[{}],"m":"last"}"#);
    }
}
