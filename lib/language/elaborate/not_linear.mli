(** The error SC0218: a value that depends on parameters with known ranges stands where it cannot. *)

open Scc_base

val report : Report.t -> ?needed:Span.t -> Span.t -> why:string -> Form.t -> unit
(** [report r ?needed at ~why form] reports that [form] cannot stand at [at], for the reason [why]. [needed] is
    the place that requires a constant, if it is another one. *)
