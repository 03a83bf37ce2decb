(** Three-valued truth (Kleene): a predicate holds, does not hold, or cannot be decided, for a reason. *)

type t = True | False | Undecided of string  (** the reason, in words *)

val of_bool : bool -> t
(** [of_bool b] is [True] or [False]. *)

val not_ : t -> t
(** [not_ a] is the negation; [Undecided] stays. *)

val and_ : t -> t -> t
(** [and_ a b] is the conjunction: [False] if one is [False]. If both are undecided, the first reason is kept. *)

val or_ : t -> t -> t
(** [or_ a b] is the disjunction: [True] if one is [True]. If both are undecided, the first reason is kept. *)

val equal : t -> t -> bool
(** [equal a b] is true for equal truth values; two undecided ones must have equal reasons. *)

val to_string : t -> string
(** [to_string a] is ["true"], ["false"] or ["undecided: "] with the reason. *)
