//! Documents on disk, recovery files, imports and exports.
