(** What a run of [scc check] took, as JSON ([specs/schema/check.schema.json]). *)

open Scc_json

type t = {
  states_per_second : int;
  transitions_per_second : int;
  peak_heap_bytes : int;
  peak_resident_bytes : int option;  (** where the system tells it *)
  store_bytes : (string * int) list;  (** of states, labels and edges *)
  longest_numbers : (string * int) list;  (** in bits, of each kind of number *)
  minor_collections : int;
  major_collections : int;
  microseconds : (string * int) list;  (** of each phase *)
}

val format : (t, unit) Json_format.t
(** The format of the member [measured]. *)
