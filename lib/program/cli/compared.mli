(** The inputs of [scc compare]: models and graphs. *)

open Scc_base
open Scc_exact
open Scc_verify
open Scc_equivalence

(** The origin of a graph. *)
type source =
  | Model of { model : Scc_loading.Loaded.t; space : Explored.t }
  | File  (** in the format .aut *)

(** A graph to be compared. *)
type t = {
  path : string;
  source : source;
  graph : Graph.t Later.t;  (** with the labels of the model; time passes for ever in quiescent states *)
  complete : bool;  (** no state is unknown *)
}

val graph_of_space : ?renamed:(string -> string) -> Explored.t -> Graph.t
(** The graph of an exploration with the labels of its transitions. The two bodies of a bounce have the least
    names of their processes, so the order of declarations does not matter. [renamed] gives the names that are
    compared. *)

val load :
  Console.t ->
  Setup.t ->
  ?renamed:(string -> string) ->
  overrides:(string * Rat.t) list ->
  string ->
  (t, Diag.t list) result
(** Reads the file and, if it is a model, explores it. Warnings of the model are reported. *)

val stopped_by : t -> Verdict.truncation list
(** The bounds that left states of the model unexplored. *)

val size : t -> int * int
(** The numbers of states and transitions that were read or explored. *)
