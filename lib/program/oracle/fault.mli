(** Errors of requests, as in [specs/oracle.md]. *)

open Scc_base
open Scc_json

(** The resource of which a request needs too much. *)
type stop = Seconds | Memory

(** A place in the params. *)
type place = Member of string | Item of place * int | Within of place * string

type t =
  | Parse of int * string  (** the offset of the byte, and the reason *)
  | Invalid_request of string
  | No_method of string
  | Invalid_params of place * string
  | Internal of string
  | Limit of string * int  (** its name and its value *)
  | Unknown_handle of string
  | Shape_refused of Json.t list  (** faults as in {!Scc_reports.Shape_json} *)
  | Model_refused of Json.t list  (** diagnostics as in {!Scc_runs.Diag_json} *)
  | Stopped of stop
  | Not_possible of { at : int; possible : string list; message : string }
  | No_transitions of { at : int; diagnostics : Json.t list }
  | Formula_refused of Json.t list
  | Not_in_contact of { at : int; relation : string }

exception Refused of t
(** Ends a request from any function of this library. {!Oracle} catches it. *)

val refuse : t -> 'a
(** Raises {!Refused}. *)

val invalid : place -> ('a, unit, string, 'b) format4 -> 'a
(** Raises {!Refused} with [Invalid_params]. *)

val format : (t, unit) Json_format.t
(** The format of the member [error] of a response. Its codes are those of JSON-RPC (-32700 and -32603 to
    -32600) by its standard, and -32000 to -32008 for errors of the service. *)

val diagnostics : source:(string -> Source.t option) -> Diag.t list -> Json.t list
(** Diagnostics as objects, as in {!Scc_runs.Diag_json}. [source] returns the text of a file by its name. *)
