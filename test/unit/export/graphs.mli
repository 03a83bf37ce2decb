(** Graphs to export: explored from texts, and made by hand. *)

open Scc_semantics
open Scc_verify
open Scc_graphs

val explored : ?options:Setup.t -> string -> Exported.t
(** Of a model's text, to which the shape Cube is added. *)

val made : ?unexplored:int list -> ?resting:int list -> (Transition.label * int) list array -> Exported.t
(** With these transitions out of each state; all states look alike. *)

val written : ((string -> unit) -> unit) -> string

val labelling : ?instants:bool -> Exported.t -> Labelling.t
(** By the predicates of the checks. *)
