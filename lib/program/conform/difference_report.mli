(** The result of {!Difference} as text. *)

val text : Recorded.t -> Recorded.t -> Difference.t option -> string
(** The result as lines of text. *)

val set : string list -> string
(** The names of rules as a set, such as ["{Bind, Time}"]. *)
