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
  | Absorb  (** in models in which some body absorbs *)
  | Time
  | Steer
  | Draw  (** in models with a law that leaves velocities to chance *)
  | Lot  (** in models in which a weak split is left to chance *)
  | Turn  (** in the rigid calculus only *)
  | Round  (** in the rigid calculus, and in models that round velocities *)

val id : t -> string
(** The name of a rule as in the rule book: ["Pre"], ["WeakSplit"], ["StrongSplit"], ["TimeBehaviour"], … *)

val all : t list
(** All rules, each once, in the order of their constructors. *)

val of_model : Scc_calculus.Model.t -> t list
(** The rules that apply to a model, in the order of {!all}. {!Close}, {!Absorb}, {!Draw}, {!Lot}, [Turn] and
    {!module-Round} apply to some models only. *)
