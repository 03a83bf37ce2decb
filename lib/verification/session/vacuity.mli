(** Warnings about checks that hold only because nothing could violate them. Such warnings need a complete
    exploration, so that none is wrong. A warning changes no verdict. *)

open Scc_base
open Scc_verify
open Scc_loading

val impossible : Loaded.t -> Diag.t list
(** SC0704 for each event of a check that no behaviour can cause. One example is a bind on a channel that is
    not open both as [a] and as [~a] anywhere. Another is a split of bonds that no behaviour releases in this
    way. The text of the behaviours decides, without exploration. *)

val warnings :
  Check.report ->
  verdicts:Verdict.outcome list ->
  answers:Verdict.outcome list ->
  Diag.t list
(** SC0703 if some check holds and no event ever happens. SC0702 for each premise ({!Loaded.t}), decided beside
    the checks, that never holds. Warnings SC0705 and SC0706 of the report come first. *)
