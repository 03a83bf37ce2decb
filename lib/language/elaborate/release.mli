(** The force and the odds of a split, which stand beside its channel. *)

open Scc_exact
open Scc_syntax
open Scc_calculus

val push : Report.t -> Env.t -> Ast.expr option -> Rat.t option
(** The impulse of a split (reading I-36), in mass times length per time; 0 if none is given. A negative one is
    SC0208. *)

val odds : Report.t -> splits:Model.splits -> Env.t -> Ast.odds option -> Odds.t option option
(** The chance or the rate of a weak split (rule Lot); [Some None] if none is given. A number that is no
    probability or no rate is SC0208. Odds without split instants are SC0505. *)

val has_one_sign : Report.t -> Scc_base.Span.t -> string -> Ranges.range -> Rational_function.t -> Rat.t -> bool
(** [has_one_sign report at what range f value] is true if [f] is positive strictly within the range of the
    parameter (SC0208 otherwise, with a value of the parameter). [value] is one value of [f] there, and [what]
    names it. *)
