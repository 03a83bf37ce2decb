(** What [scc compare] says. *)

open Scc_equivalence

type t = {
  relation : Compare.relation;
  first : Compared.t;
  second : Compared.t;
  report : Compare.report;
  exit : Scc_session.Exit_code.t;
}

val relations : (string * Compare.relation) list
(** By name. *)

val text : Console.t -> t -> string

val json : Console.t -> t -> Scc_exchange.Json.t
(** See [specs/schema/compare.schema.json]. *)
