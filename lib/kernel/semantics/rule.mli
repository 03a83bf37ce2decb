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
  | Close  (** with {!Scc_calculus.Model.Cyclic} only *)
  | Bounce
  | Absorb  (** of models in which some body absorbs *)
  | Time
  | Steer
  | Draw
  | Lot  (** of models in which a weak split has a chance *)
  | Turn  (** of the rigid calculus only, as is *)
  | Round

val id : t -> string
(** As in the rule book: ["Pre"], ["WeakSplit"], ["StrongSplit"], ["TimeBehaviour"], … *)

val all : t list

val of_model : Scc_calculus.Model.t -> t list
(** Those that apply to a model: {!Close}, {!Absorb}, {!Draw}, {!Lot}, {!Turn} and {!Round} are for some only. *)
