(** Where the passes of elaboration put what they find. One report serves one elaboration; a pass that finds
    a fault reports it and goes on without the thing, so that one run shows as many faults as make sense. *)

open Scc_base

type t

val create : unit -> t

val error :
  t ->
  ?notes:(Span.t * string) list ->
  ?hint:string ->
  ?near:string * (unit -> string list) ->
  Code.t ->
  Span.t ->
  ('a, unit, string, unit) format4 ->
  'a
(** [error r code span fmt …]. [near] is [(name, candidates)]: the hint proposes the candidate that the name
    was likely meant to be, and is only looked for when the error is kept. Of the errors with one code at
    one place (in a loop, say) the first few are kept. *)

val warning :
  t ->
  ?notes:(Span.t * string) list ->
  ?hint:string ->
  Code.t ->
  Span.t ->
  ('a, unit, string, unit) format4 ->
  'a

val add : t -> Diag.t -> unit
val failed : t -> bool
(** Whether there is an error. *)

val errors : t -> Diag.t list
(** In the order of the text, without repetition. *)

val warnings : t -> Diag.t list
