(** Warnings about checks that hold for want of anything that could speak against them. Only what was explored
    completely is warned of, so that no warning is wrong; a warning changes no verdict. *)

open Scc_base
open Scc_verify

val impossible : Loaded.t -> Diag.t list
(** SC0704 for each event of a check that no behaviour can bring about: a bind on a channel that is not open
    both as [a] and as [~a] anywhere, a split of bonds that none releases in this way. The text of the
    behaviours tells, without exploration. *)

val warnings :
  Check.report ->
  verdicts:Verdict.outcome list ->
  answers:Verdict.outcome list ->
  Diag.t list
(** SC0703 when some check holds and no event ever happens, SC0702 for each premise
    ({!Loaded.t}), decided beside the checks, that never holds. *)
