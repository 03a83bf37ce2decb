(** From checks to properties: names are resolved, quantifiers are expanded over the leaves of the network, and
    types are checked. *)

open Scc_syntax
open Scc_property

type t = Subjects.t

val create : Context.t -> Bodies.t -> Composition.t -> Behaviours.t -> t
(** The subjects of formulas over this network, with full budgets of terms. *)

val copy : t -> Context.t -> t
(** [copy t c] has the same subjects, with behaviours and budgets of its own ({!Subjects.copy}). It reports to
    [c]. *)

val check_let : t -> Env.t -> Ast.expr -> unit
(** Reports the faults of a [let] that nothing uses, if it makes sense neither in a law of motion nor in a
    formula. *)

val check : t -> Program.check -> Property.check option
(** Elaborates a check. A formula without a temporal operator is SC0701; operators nested deeper than
    {!Limits.operators} are SC0111.

    A quantifier over a template ranges over the leaves declared with it, [fixed] ones included. A leaf that is
    scaled in its own declaration ([Cube scaled (…)]) counts as one of the unscaled template. A leaf of a
    template that was declared by scaling counts as one of that template only. A quantifier over the name of a
    process or of a family ranges over its leaves. *)

val premises : t -> Program.check -> Property.check list
(** The premises of a check that {!check} accepts. For each of its {!Premises} that is a state predicate, the
    property says that some run meets it. Name is that of the check; place and text are those of the premise.
    Nothing is reported. *)
