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
  | Turn  (** of the rigid calculus only, as is *)
  | Round

val id : t -> string
(** As in the rule book: ["Pre"], ["WeakSplit"], ["StrongSplit"], ["TimeBehaviour"], … *)

val all : t list

val of_model : Scc_calculus.Model.t -> t list
(** Those that apply to a model: without {!Turn} and {!Round} when it is not rigid. *)
