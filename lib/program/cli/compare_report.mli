(** The report of [scc compare]. *)

open Scc_equivalence

(** The result of a comparison. *)
type t = {
  relation : Compare.relation;
  first : Compared.t;
  second : Compared.t;
  report : Compare.report;
  exit : Scc_verdicts.Exit_code.t;
}

val relations : (string * Compare.relation) list
(** The relations by name: [trace], [weak], [branching], [strong] and [timed]. *)

val text : Console.t -> t -> string
(** The result as lines of text. *)

val json : Console.t -> t -> Scc_json.Json.t
(** The document by [specs/schema/compare.schema.json]. *)
