(** The rules of the rule book, by name. *)

type t =
  | Pre
  | Weak
  | Strong
  | Sum
  | Def
  | Eps0
  | Time_behaviour
  | Weak_split
  | Strong_split
  | Bind
  | Bounce
  | Time
  | Steer

val id : t -> string
(** As in the rule book: ["Pre"], ["WeakSplit"], ["StrongSplit"], ["TimeBehaviour"], … *)

val all : t list
