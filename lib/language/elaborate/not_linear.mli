(** What depends on parameters of which ranges are known stands where it cannot (SC0218). *)

open Scc_base

val report : Report.t -> ?needed:Span.t -> Span.t -> why:string -> Form.t -> unit
(** At the place, with the reason; [needed] is where it is asked for, if that may be elsewhere. *)
