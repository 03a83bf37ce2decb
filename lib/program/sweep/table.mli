(** A sweep as a table. *)

open Scc_session

type t = {
  name : string option;  (** of the model *)
  digest : string;
  grid : Grid.t;
  bounds : (string * string) list;
}

val csv_header : t -> string

val csv : t -> int -> Outcome.t -> string
(** A line for each check at the point of this number; one if the model is invalid there. *)

val json_header : t -> string
(** What was asked for, which tells one sweep from another one ([specs/schema/sweep.schema.json]). *)

val json : t -> int -> Outcome.t -> string
(** The point, in one line. *)

val origin : Origin.t -> string option * string
(** Name and digest, which do not depend on the point. *)
