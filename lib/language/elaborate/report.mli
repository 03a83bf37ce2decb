(** The diagnostics of one elaboration. A pass that finds a fault reports it and continues without the faulty
    part, so one run shows as many faults as make sense. *)

open Scc_base

(** The diagnostics found so far. *)
type t

val create : unit -> t
(** An empty report. *)

val copy : t -> t
(** A report with the same diagnostics. What is added to one of the two is not in the other. *)

val error :
  t ->
  ?notes:(Span.t * string) list ->
  ?hint:string ->
  ?near:string * (unit -> string list) ->
  Code.t ->
  Span.t ->
  ('a, unit, string, unit) format4 ->
  'a
(** [error r code span fmt …] adds an error. [near] is [(name, candidates)]: the hint then suggests the
    candidate that is most similar to the name. The candidates are computed only if the error is kept. At most 3
    errors of one code at one place (in a loop, say) are kept, and at most 200 in all. *)

val warning :
  t ->
  ?notes:(Span.t * string) list ->
  ?hint:string ->
  Code.t ->
  Span.t ->
  ('a, unit, string, unit) format4 ->
  'a
(** [warning r code span fmt …] adds a warning. *)

val add : t -> Diag.t -> unit
(** Adds a diagnostic as it is, without any limit. *)

val leave_out : t -> Code.t -> unit
(** [leave_out r code] drops the diagnostics of this code, those to come as well, because they follow from another
    error. *)

val failed_besides : t -> Code.t -> bool
(** [failed_besides r code] is true if the report has an error of another code. *)

val failed : t -> bool
(** [failed r] is true if the report has an error. *)

val errors : t -> Diag.t list
(** The errors in the order of the text, without repetition. *)

val warnings : t -> Diag.t list
(** The diagnostics that are no errors, in the order of the text, without repetition. *)
