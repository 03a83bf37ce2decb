(** Checking models over all values of their parameters, and all instants of their splits (rule Zones). *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_symbolic
open Scc_verify

val is_for : Model.t -> declared:State.t -> bool
(** [is_for m ~declared] is true if the model has parameters with ranges, or bonds that may be released at any
    time. *)

(** The use of a model that needs affine numbers. *)
type use =
  | Zones  (** the model leaves numbers open, and its checks are asked *)
  | Graph  (** the model leaves numbers open, and the graph of its zones is asked *)
  | Invariants  (** a proof is requested *)

val refused : Model.t -> use -> Scc_base.Diag.t list
(** The reasons (SC0901) why numbers of such a model are not affine in its variables; none if they are. Reasons
    are bodies that turn, a law of motion, rounded velocities, and bonds on contact. *)

type fault = {
  at : (string * Rat.t) list;  (** values of the parameters *)
  reason : Start.reason;
}

val diagnostic : Model.t -> fault -> Scc_base.Diag.t
(** The error that for these values bodies interpenetrate (SC0403), or bound features do not touch (SC0401). It
    has no place in the text. *)

val run :
  Setup.t -> Semantics.t -> Uncertain.t -> declared:State.t -> exactly:bool ->
  premises:Property.check list -> Property.check list -> (Check.report, fault) result
(** [run options m u ~declared ~exactly ~premises checks] is a verdict for each check, over all values, and the
    values for which it holds ({!Check.report.where}). With [exactly] these are as complete as possible, else
    as complete as the verdict needs. Outcomes of premises, which have the names of checks, come after those of
    the checks. A premise is violated if it is known that no run meets it for any values, else undecided.
    Premises prolong no exploration. The error has values for which the declared state is not well-formed. *)
