(** A sweep as a table. *)

open Scc_loading

(** A sweep, as its table describes it. *)
type t = {
  name : string option;  (** of the model *)
  digest : string;
  grid : Grid.t;
  bounds : (string * string) list;
  checks : string list;  (** the names of those that were chosen; none: all *)
  decimals : int option;  (** of numbers in CSV: ends of intervals are rounded outwards *)
  diffuses : bool;  (** true if some body may diffuse: then there is a column of the lengths of kicks *)
  estimated : (string * string) list option;
  (** the options of estimates, if the checks are estimated from runs: then there are columns for these *)
}

val csv_header : t -> string
(** The names of the columns, in one line. A parameter with the name of another column has it in brackets. *)

val csv : t -> int -> Outcome.t -> string
(** A line for each check at the point of this number, and a single line if the model is invalid there. *)

val format : ((t, t * int * Outcome.t) Either.t, unit) Scc_json.Json_format.t
(** The format of a line of JSON: the header, or the result at the point of a number. *)

val json_header : t -> string
(** The model, bounds and grid, which distinguish one sweep from another ([specs/schema/sweep.schema.json]), in
    one line. *)

val json : t -> int -> Outcome.t -> string
(** The result at a point, in one line. *)

val origin : Origin.t -> string option * string
(** The name and the digest of a model, which do not depend on the point. *)
