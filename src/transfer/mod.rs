//! Programs over the wire: links, protocols, the virtual lathe.
