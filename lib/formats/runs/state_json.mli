(** States and transition labels as JSON (see [specs/schema]). Lengths are in the units of the model and
    positions in the world; velocities are in these lengths per unit of time. *)

open Scc_calculus
open Scc_semantics
open Scc_json

val label_format : (Model.t * Transition.label, unit) Json_format.t
(** The format of a transition label [{"kind", "text", …}]: its kind, its text, and its parts by name. *)

val tie_chance : ('a -> Transition.label * Scc_exact.Rat.t option) -> ('a, unit) Json_format.members
(** [tie_chance part] is the member ["chance"] of a transition that is one of several urgent ones in a model that draws
    ties (rule Ties). [part x] is its label, and its probability if chance decides. Other transitions do not have
    the member. *)

val state_format : (Model.t * State.t, unit) Json_format.t
(** The format of a state in full. *)

val bond_format : (Model.t * State.bond, unit) Json_format.t
(** The format of a bond: [name] and [ends]. *)

val ends : (Model.t * State.bond, unit) Json_format.t
(** The format of the features at the two ends of a bond. *)

val behaviour : Model.t -> leaf:int -> Behaviour.aged -> string
(** The term of the leaf in the syntax of the language, as by {!Behaviour_text.to_string}. *)

val phase : State.phase -> string
(** The phase of a movement step: ["moving"], ["due"] or ["steered"]. *)

val kind : Transition.label -> string
(** The kind of a label: ["time"], ["bind"], ["close"], ["bounce"], ["absorb"], ["weak"], ["strong"], ["draw"]
    or ["lot"]. *)

val origin : Model.t -> Behaviour.aged -> string option
(** The name of the definition that the behaviour comes from, if there is one. *)
