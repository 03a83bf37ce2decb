(** Three-valued truth (Kleene): a predicate holds, does not hold, or cannot be decided, for a reason. *)

type t = True | False | Undecided of string  (** why, for a person *)

val of_bool : bool -> t
val not_ : t -> t
val and_ : t -> t -> t

val or_ : t -> t -> t
(** Of two reasons, the first is kept. *)

val equal : t -> t -> bool
val to_string : t -> string
