(** Errors of the translation, as an exception within it. *)

open Scc_base

exception Found of Diag.t

val refuse :
  ?hint:string -> ?notes:(Span.t * string) list -> Code.t -> Span.t -> ('a, unit, string, 'b) format4 -> 'a

val ok : ('a, Diag.t) result -> 'a
val catch : (unit -> 'a) -> ('a, Diag.t) result
