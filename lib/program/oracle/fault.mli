(** Why a request has no answer: the errors of [specs/oracle.md]. *)

open Scc_base
open Scc_exchange

type stop = Seconds | Memory

(** Where in the params something is. *)
type place = Member of string | Item of place * int | Within of place * string

type t =
  | Parse of int * string  (** the offset of the byte, and why *)
  | Invalid_request of string
  | No_method of string
  | Invalid_params of place * string
  | Internal of string
  | Limit of string * int  (** its name and what it is *)
  | Unknown_handle of string
  | Shape_refused of Json.t list  (** faults as in {!Scc_exchange.Shape_json} *)
  | Model_refused of Json.t list  (** diagnostics as in {!Scc_exchange.Diag_json} *)
  | Stopped of stop
  | Not_possible of { at : int; possible : string list; message : string }
  | No_transitions of { at : int; diagnostics : Json.t list }
  | Formula_refused of Json.t list
  | Not_in_contact of { at : int; relation : string }

exception Refused of t
(** How deep functions of this library end a request. It does not leave {!Oracle}. *)

val refuse : t -> 'a

val invalid : place -> ('a, unit, string, 'b) format4 -> 'a
(** Refuses with [Invalid_params]. *)

val place : place -> string
(** ["faces[3][1]"], ["first.mass"]. *)

val code : t -> int
val message : t -> string
val data : t -> Json.t
val diagnostics : source:(string -> Source.t option) -> Diag.t list -> Json.t list
