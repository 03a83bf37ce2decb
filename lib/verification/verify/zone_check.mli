(** Checking models over all values of their parameters, and all instants of their splits (rule Zones). *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_symbolic

val is_for : Model.t -> declared:State.t -> bool
(** The model has parameters of which a range is known, or bonds that may be released at any time. *)

(** What a model is wanted for. *)
type use = Zones  (** it has numbers that are not known *) | Invariants  (** a proof is asked for *)

val refused : Model.t -> use -> Scc_base.Diag.t list
(** Why numbers of such a model are not affine in what is not known, if they are not (SC0901): bodies turn, a law
    of motion steers them, velocities are rounded, or they bind on contact. *)

type fault = {
  at : (string * Rat.t) list;  (** values of the parameters *)
  reason : Start.reason;
}

val diagnostic : Model.t -> fault -> Scc_base.Diag.t
(** That for these values bodies interpenetrate (SC0403), or what is bound does not touch (SC0401). It knows no
    places in the text. *)

val run :
  Joint_check.options -> Semantics.t -> Uncertain.t -> declared:State.t -> exactly:bool ->
  premises:Property.check list -> Property.check list -> (Check.report, fault) result
(** A verdict for each check, over all values, and for which of them it holds ({!Check.report.where}): all that
    can be known of that with [exactly], else as much as the verdict takes. After the outcomes of the checks come
    those of premises, which have the names of checks: violated where it is known that no run ever meets it, for
    whatever values, else undecided. They keep no exploration going. The error: for these values the declared state
    is not well-formed. *)
