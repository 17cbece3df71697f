//! Why a command did not do what it was asked for.

/// Why a command ended early, by exit status.
pub(super) enum Failure {
    /// 2: the command line does not make sense.
    Usage(String),
    /// 1, or 3 where no adapter answers: the input is wrong.
    Input(orogen::Error),
    /// 1: a file cannot be written, and the like.
    System(String),
    /// 1: everything has been said.
    Reported,
}

impl From<orogen::Error> for Failure {
    fn from(error: orogen::Error) -> Self {
        Self::Input(error)
    }
}

pub(super) type Outcome = Result<(), Failure>;
