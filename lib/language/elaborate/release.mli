(** What a split says beside its channel: how hard it pushes, and how likely it is. *)

open Scc_exact
open Scc_syntax
open Scc_calculus

val push : Report.t -> Env.t -> Ast.expr option -> Rat.t option
(** An impulse (reading I-36), 0 where none is given. SC0208 for a negative one. *)

val odds : Report.t -> splits:Model.splits -> Env.t -> Ast.odds option -> Odds.t option option
(** The chance or the rate of a weak split (rule Lot), [Some None] where none is given. SC0208 for what is no
    probability or no rate, SC0505 where there are no split instants. *)
