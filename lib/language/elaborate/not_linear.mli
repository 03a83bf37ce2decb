(** The error SC0218: a value that depends on parameters with known ranges stands where it cannot. *)

open Scc_base
open Scc_calculus

val report : Report.t -> ?needed:Span.t -> Span.t -> why:string -> Form.t -> unit
(** [report r ?needed at ~why form] reports that [form] cannot stand at [at], for the reason [why]. [needed] is
    the place that requires a constant, if it is another one. *)

val refuse : Report.t -> ?needed:Span.t -> Span.t -> why:string -> Open_number.t -> unit
(** [refuse r ?needed at ~why n] reports that a value that depends on the parameter of [--parametric] cannot stand
    at [at], for the reason [why]. [needed] is as for {!report}. *)
