(** Checks to properties: names resolved, quantifiers expanded over the leaves of the network, types
    checked. *)

open Scc_syntax
open Scc_property

type t = Subjects.t

val create : Context.t -> Bodies.t -> Composition.t -> Behaviours.t -> t

val check_let : t -> Env.t -> Ast.expr -> unit
(** Reports what is wrong with an expression that nothing uses: one that makes sense neither in a law of
    motion nor in a formula. *)

val check : t -> Program.check -> Property.check option
(** A formula with a temporal operator (SC0701 otherwise).

    A quantifier over a template ranges over the leaves declared with it, [fixed] ones included; a leaf that
    is scaled where it is declared ([Cube scaled (…)]) counts as one of what is scaled, a leaf of a template
    that was declared by scaling counts as one of that template only. A quantifier over the name of a
    process or of a family ranges over its leaves. *)

val premises : t -> Program.check -> Property.check list
(** Of a check that {!check} took: for each of its {!Premises} that is a state predicate, whether some run ever
    meets it. The name is the check's; place and text are the premise's. *)
