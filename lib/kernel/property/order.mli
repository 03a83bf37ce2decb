(** Total orders on the terms of {!Property}: without meaning, but the same on every machine. *)

open Property

val num : num -> num -> int
val prop : prop -> prop -> int
val event : event -> event -> int
val temporal : temporal -> temporal -> int
val quantifier : path_quantifier -> path_quantifier -> int
val bound : bound -> bound -> int
