(** What [scc compare] is given: models and graphs. *)

open Scc_base
open Scc_exact
open Scc_verify
open Scc_equivalence

type source =
  | Model of { model : Scc_session.Loaded.t; space : Explored.t }
  | File  (** in the format .aut *)

type t = {
  path : string;
  source : source;
  graph : Graph.t Later.t;  (** with the labels of the model; where it is quiescent, time passes for ever *)
  complete : bool;  (** no state is unknown *)
}

val is_graph_file : string -> bool
(** By its extension, [.aut]. *)

val graph_of_space : ?renamed:(string -> string) -> Explored.t -> Graph.t
(** With the labels of the transitions, but that the two that bounce are called by the least names of their bodies,
    so that the order of declarations is not seen; [renamed] gives the names that count. *)

val load :
  Console.t ->
  Check.options ->
  ?renamed:(string -> string) ->
  overrides:(string * Rat.t) list ->
  string ->
  (t, Diag.t list) result
(** Reads the file and, if it is a model, explores it; reports the model's warnings. *)

val stopped_by : t -> Verdict.truncation list
(** The bounds that left states of the model unexplored. *)

val size : t -> int * int
(** States and transitions, as they were read or explored. *)
