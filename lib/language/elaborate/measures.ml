open Scc_base
open Scc_exact
open Scc_syntax
open Scc_property

type reader = {
  report : Report.t;
  env : Env.t;
  formula : Ast.expr -> Property.temporal option;
  bound : Ast.bound option -> Property.bound option;
  value : Ast.expr -> (Property.num, Property.temporal) Typed.value option;
}

let error r code at ?hint format = Report.error r.report code at ?hint format

(* {1 What stands before the bracket} *)

type kind = Probability | Mean

(* And over which schedulers: without a word for it over all of them, whatever they do. *)
let measures =
  let both = [ Property.Least; Greatest ] in
  [
    ("P", (Probability, both)); ("Pmin", (Probability, [ Least ])); ("Pmax", (Probability, [ Greatest ]));
    ("E", (Mean, both)); ("Emin", (Mean, [ Least ])); ("Emax", (Mean, [ Greatest ]));
  ]

let words = List.map fst measures

let known (m : Ast.expr) =
  match m.it with
  | Path { it = [ { name; indices = [] } ]; _ } -> List.assoc_opt name.it measures
  | _ -> None

let measure r (m : Ast.expr) =
  let found = known m in
  if Option.is_none found then
    error r Code.not_a_formula m.at "`%s` stands before what runs do, and a probability or a mean is expected"
      (Printer.expr m) ~hint:"these are `P`, `Pmin`, `Pmax`, `E`, `Emin` and `Emax`";
  found

let is_question m test =
  match (known m, test) with
  | _, None | Some (Mean, _), _ -> true
  | (Some (Probability, _) | None), Some _ -> false

(* What is meant of all schedulers is so of the one for which it is hardest. *)
let compared (o : Ast.binary) : Scc_chance.Answer.relation * Property.side =
  match o with
  | Lt -> (Less, Greatest)
  | Le -> (At_most, Greatest)
  | Gt -> (More, Least)
  | Ge -> (At_least_so, Least)
  | Add | Sub | Mul | Div | Mod | Eq | Ne | And | Or | Implies -> Bug.fail __POS__ "no threshold"

let threshold r sides (o, (e : Ast.expr)) =
  let relation, of_all = compared o in
  let side = match sides with [ side ] -> side | _ -> of_all in
  Option.map (fun than -> (side, { Scc_chance.Answer.relation; than })) (Constant.number r.report r.env e)

let chance r sides ((_, (e : Ast.expr)) as test) =
  let*? side, test = threshold r sides test in
  if Rat.sign test.than >= 0 && Rat.compare test.than Rat.one <= 0 then Some (Property.Chance { side; test })
  else begin
    error r Code.bad_value e.at "a probability is from 0 to 1, and this is %s" (Rat.to_string test.than);
    None
  end

(* {1 What runs do} *)

let outcome r quantifier (o : Ast.outcome) =
  match o with
  | Does { it = Temporal (((Eventually | Always) as operator), written, f); _ } ->
    let*? b, f = Typed.both (r.bound written) (r.formula f) in
    Some (match operator with Always -> Property.Globally (quantifier, b, f) | _ -> Finally (quantifier, b, f))
  | Goes_until (f, written, g) ->
    let f = r.formula f and g = r.formula g in
    let*? b = r.bound written in
    let*? f, g = Typed.both f g in
    Some (Property.Until (quantifier, b, f, g))
  | Does e ->
    error r Code.not_a_formula e.at "what a run does is expected here, and this is none"
      ~hint:"write `eventually …`, `always …` or `f U g`";
    None
  | Has_at (e, _) ->
    error r Code.not_a_formula e.at "a probability is one of what a run does, and not of a value at a time"
      ~hint:"write `eventually[t, t] …` for what is so at the time t";
    None

(* {1 Means} *)

let needs_time r at =
  error r Code.not_a_formula at "a mean is one of a number, and this is none"
    ~hint:"write `time U f`, `event … U f`, or a number and `at` a time";
  None

let all_events f =
  List.for_all (fun (a : Atom.t) -> Option.is_some a.event) (Formula.atoms f) && Formula.atoms f <> []

let until r any (f : Ast.expr) g =
  let left = r.value f and g = r.formula g in
  let*? left, g = Typed.both left g in
  match left with
  | Typed.Num (Quantity Time) -> Some (Property.Time_until g, Property.Finally (any, Formula.always, g))
  | Cond (State p) when all_events (Property.State p) ->
    Some (Events_until (p, g), Until (any, Formula.always, State p, g))
  | Num _ | Vec _ | Cond _ ->
    error r Code.not_a_formula f.at "before the `U` of a mean stands `time`, or events that are counted";
    None

let mean r any (o : Ast.outcome) =
  match o with
  | Goes_until (f, None, g) -> until r any f g
  | Goes_until (_, Some (Within e | At_most e | Between (_, e)), _) ->
    error r Code.not_a_formula e.at "a mean until something holds takes no bound of time";
    None
  | Has_at (e, t) -> (
      let value = r.value e and time = Constant.number r.report r.env t in
      let*? value, time = Typed.both value time in
      match value with
      | Typed.Num n when Rat.sign time >= 0 ->
        let at = { Property.low = time; high = Some time } in
        Some (Property.Value_at (n, time), Property.Finally (any, at, State (Compare (Ge, n, Const Rat.zero))))
      | Num _ ->
        error r Code.bad_value t.at "a time is not negative, and this is %s" (Rat.to_string time);
        None
      | Vec _ | Cond _ -> needs_time r e.at)
  | Does e -> needs_time r e.at

(* {1 Both} *)

let formula r at m test o =
  let*? kind, sides = measure r m in
  match (kind, test) with
  | Probability, Some test ->
    let*? quantifier = chance r sides test in
    outcome r quantifier o
  | Probability, None | Mean, _ ->
    error r Code.not_a_formula at "this asks about a number, and a formula is expected here"
      ~hint:"a check may ask for it, if nothing stands around";
    None

(* The quantifier of a question does not matter but for its side: that of which there is a run to show. *)
let any sides =
  let side = if List.mem Property.Greatest sides then Property.Greatest else Least in
  Property.Chance { side; test = { relation = At_least_so; than = Rat.zero } }

let question r m test o =
  let*? kind, sides = measure r m in
  match (kind, test) with
  | Probability, _ -> Option.map (fun f -> (Property.How_likely sides, f)) (outcome r (any sides) o)
  | Mean, None -> Option.map (fun (mean, f) -> (Property.Expected (sides, mean, None), f)) (mean r (any sides) o)
  | Mean, Some test ->
    let*? side, test = threshold r sides test in
    Option.map (fun (mean, f) -> (Property.Expected ([ side ], mean, Some test), f)) (mean r (any [ side ]) o)
