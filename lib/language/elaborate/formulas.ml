open Scc_base
open Scc_exact
open Scc_syntax
open Scc_property
open Subjects

type t = Subjects.t

let state_of t at ~hint = function
  | Property.State p -> Some p
  | _ ->
    error t Code.type_mismatch at "a state predicate is expected here, and this is a temporal formula" ~hint;
    None

let all options = if List.for_all Option.is_some options then Some (List.filter_map Fun.id options) else None

let states formulas =
  all (List.map (function Property.State p -> Some p | _ -> None) formulas)

let conjunction formulas =
  match states formulas with
  | Some ps -> Property.State (And ps)
  | None -> Temporal_and formulas

let disjunction formulas =
  match states formulas with
  | Some ps -> Property.State (Or ps)
  | None -> Temporal_or formulas

let members t env v = function
  | Ast.Numbers r -> Indices.numbers t.c.report env v r
  | Ast.Bodies e ->
    let*? leaves = range t env e in
    Some (List.filter_map (fun i -> if i >= 0 then Some (Env.Leaf i) else None) leaves)

let quantified t eval env (q : Ast.quantifier) (v : Ast.name) over (body : Ast.expr) =
  let*? values = members t env v over in
  let instance value =
    let env = Env.add v.it { Env.value; span = v.at; used = false } env in
    match eval env body with
    | Some (Typed.Cond f) -> Some f
    | Some ((Typed.Num _ | Vec _) as v) ->
      error t Code.type_mismatch body.at "a truth value is expected here, and this is %s" (Typed.described v);
      None
    | None -> None
  in
  let*? formulas = all (List.map instance values) in
  match q with
  | Forall -> Some (Typed.Cond (conjunction formulas))
  | Exists -> Some (Typed.Cond (disjunction formulas))
  | Count ->
    let hint = "what is counted holds or not at an instant" in
    let*? ps = all (List.map (state_of t body.at ~hint) formulas) in
    Some (Typed.Num (Property.Count ps))

let duration t env (e : Ast.expr) =
  match Constant.number t.c.report env e with
  | Some q when Rat.sign q >= 0 -> Some q
  | Some q ->
    error t Code.bad_value e.at "a time bound is not negative, and this is %s" (Rat.to_string q);
    None
  | None -> None

let unbounded = { Property.low = Rat.zero; high = None }

let bound t env = function
  | None -> Some unbounded
  | Some (Ast.Within e | Ast.At_most e) ->
    Option.map (fun high -> { Property.low = Rat.zero; high = Some high }) (duration t env e)
  | Some (Ast.Between (a, b)) ->
    let*? low, high = Typed.both (duration t env a) (duration t env b) in
    if Rat.compare low high <= 0 then Some { Property.low; high = Some high }
    else begin
      error t Code.bad_value b.at "the time bound [%s, %s] is empty" (Rat.to_string low) (Rat.to_string high);
      None
    end

let path_quantifier : Ast.path_quantifier -> Property.path_quantifier = function
  | A -> All
  | E -> Exists

let temporal t at (operator : Ast.temporal) written b f =
  match (operator, written) with
  | Next _, Some _ ->
    error t Code.type_mismatch at "the next transition takes no time bound";
    None
  | Next q, None -> Some (Property.Next (path_quantifier q, f))
  | Possibly, _ -> Some (Finally (Exists, b, f))
  | Always, _ -> Some (Globally (All, b, f))
  | Eventually, _ -> Some (Finally (All, b, f))
  | Finally q, _ -> Some (Finally (path_quantifier q, b, f))
  | Globally q, _ -> Some (Globally (path_quantifier q, b, f))

let negate = function
  | Property.State p -> Property.State (Not p)
  | f -> Temporal_not f

(* Whenever f holds, every run from there reaches g within the bound. *)
let leads_to b f g =
  Property.Globally (All, unbounded, disjunction [ negate f; Finally (All, b, g) ])

let formula t eval env (e : Ast.expr) =
  match eval env e with
  | Some (Typed.Cond f) -> Some f
  | Some ((Typed.Num _ | Vec _) as v) ->
    error t Code.type_mismatch e.at "a formula is expected here, and this is %s" (Typed.described v);
    None
  | None -> None

(* Two formulas and the bound between them; all three report. *)
let bounded t eval env f written g =
  let f = formula t eval env f and g = formula t eval env g in
  let*? b = bound t env written in
  let*? f, g = Typed.both f g in
  Some (b, f, g)

let reader t eval env : Measures.reader =
  {
    report = t.c.report;
    env;
    formula = formula t eval env;
    bound = bound t env;
    value = (fun e -> eval env e);
  }

let other t eval env (e : Ast.expr) =
  match e.it with
  | Apply ({ it = "round"; _ }, _) when Constant.is_constant env e ->
    Option.map (fun q -> Typed.Num (Property.Const q)) (Constant.number t.c.report env e)
  | Apply (f, arguments) -> Atoms.apply t env e f arguments
  | Quantified (q, v, template, body) -> quantified t eval env q v template body
  | Temporal (operator, written, f) ->
    let*? b, f = Typed.both (bound t env written) (formula t eval env f) in
    Option.map (fun f -> Typed.Cond f) (temporal t e.at operator written b f)
  | Until (q, f, written, g) ->
    let*? b, f, g = bounded t eval env f written g in
    Some (Typed.Cond (Property.Until (path_quantifier q, b, f, g)))
  | Measured (m, test, o) ->
    Option.map (fun f -> Typed.Cond f) (Measures.formula (reader t eval env) e.at m test o)
  | Leads_to (f, written, g) ->
    let*? b, f, g = bounded t eval env f written g in
    Some (Typed.Cond (leads_to b f g))
  | Event (word, arguments) -> Atoms.event t env e.at word arguments
  | Co name ->
    error t Code.type_mismatch e.at "`~%s` is a channel, and a value is expected here" name.it;
    None
  | Apply_in _ ->
    error t Code.type_mismatch e.at "`%s` is no value, and one is expected here" (Printer.expr e)
      ~hint:"compare it, as in `behaviour(p) = m.K(a)`";
    None
  | Number _ | True | False | Path _ | Component _ | Vector _ | Neg _ | Not _ | Binary _ | If _ ->
    Bug.fail __POS__ "an expression that all algebras share"

module Algebra = struct
  type context = t
  type num = Property.num
  type cond = Property.temporal

  let report t = t.c.report
  let budget t = t.budget
  let const q = Property.Const q

  let constant = function
    | Property.Const q -> Some q
    | _ -> None

  let neg a = Property.Neg a
  let add a b = Property.Add (a, b)
  let sub a b = Property.Sub (a, b)
  let mul a b = Property.Mul (a, b)
  let div a b = Property.Div (a, b)
  let bool b = Property.State (Bool b)

  let truth = function
    | Property.State (Bool b) -> Some b
    | _ -> None

  let compare c a b = Property.State (Compare (c, a, b))

  let negate = negate
  let conj a b = conjunction [ a; b ]
  let disj a b = disjunction [ a; b ]

  let choose t at c a b = 
    state_of t at c ~hint:"a number depends on what holds at its instant"
    |> Option.map (fun p -> Property.If (p, a, b))
  let choose_cond c a b = disj (conj c a) (conj (negate c) b)

  let nearest t at what _ =
    error t Code.type_mismatch at "`%s` of what changes cannot stand in a property" what;
    None

  let admits _ _ _ _ _ = true

  let affine _ _ (form : Form.t) =
    let term ((v : Form.variable), c) =
      let parameter = Property.Quantity (Parameter v.index) in
      if Rat.equal c Rat.one then parameter else Property.Mul (Const c, parameter)
    in
    let constant = if Rat.sign form.constant = 0 then [] else [ Property.Const form.constant ] in
    match List.map term form.terms @ constant with
    | [] -> Some (Property.Const Rat.zero)
    | first :: rest -> Some (List.fold_left add first rest)

  let open_number t at n =
    Not_linear.refuse t.c.report at ~why:"formulas are about the states, which do not depend on it" n;
    None

  let variable = Atoms.variable
  let comparison = Atoms.comparison
  let other = other
end

module Eval = Typed.Make (Algebra)

let create = Subjects.create
let copy = Subjects.copy

(* Whether an operator stands there, even if the rest of the formula decides it without it. *)
let rec is_temporal (e : Ast.expr) =
  match e.it with
  | Temporal _ | Until _ | Leads_to _ | Measured _ -> true
  | Not a | Component (a, _) | Quantified (_, _, _, a) -> is_temporal a
  | Binary (_, a, b) -> is_temporal a || is_temporal b
  | If (c, a, b) -> is_temporal c || is_temporal a || is_temporal b
  | Number _ | True | False | Path _ | Co _ | Apply _ | Apply_in _ | Vector _ | Neg _ | Event _ -> false

let truth_of t (k : Program.check) =
  let*? f = Eval.cond t k.env k.formula in
  match Formula.state_formula f with
  | Some _ when not (is_temporal k.formula) ->
    error t Code.not_a_formula k.formula.at
      "a check needs a temporal operator: this holds or not at an instant"
      ~hint:"write `always …`, `possibly …` or `eventually …`";
    None
  | Some _ | None ->
    Some { Property.name = k.name; span = k.span; text = k.written k.formula; asked = Whether; formula = f }

let operators_within limit formula =
  let rec look = function
    | [] -> true
    | (level, _) :: _ when level > limit -> false
    | (level, (f : Property.temporal)) :: rest -> (
        match f with
        | State _ -> look rest
        | Temporal_not f -> look ((level, f) :: rest)
        | Temporal_and fs | Temporal_or fs -> look (List.fold_left (fun rest f -> (level, f) :: rest) rest fs)
        | Next (_, f) | Finally (_, _, f) | Globally (_, _, f) -> look ((level + 1, f) :: rest)
        | Until (_, _, f, g) -> look ((level + 1, f) :: (level + 1, g) :: rest))
  in
  look [ (0, formula) ]

let check t (k : Program.check) =
  let*? (c : Property.check) =
    match k.formula.it with
    | Measured (m, test, o) when Measures.is_question m test ->
      let*? asked, formula = Measures.question (reader t (Eval.eval t) k.env) m test o in
      Some { Property.name = k.name; span = k.span; text = k.written k.formula; asked; formula }
    | _ -> truth_of t k
  in
  if operators_within Limits.operators c.formula then Some c
  else begin
    error t Code.too_deep k.formula.at "operators of time nest more than %d deep, with their `let`s"
      Limits.operators;
    None
  end

(* What is read here has been read as part of the check, so that nothing is reported, and no budget is spent. *)
let premises t (k : Program.check) =
  let t = { t with budget = Typed.budget () } in
  let read (premise, possibly) =
    let*? f = Eval.cond t k.env possibly in
    match f with
    | Property.Finally (_, _, State _) ->
      Some { Property.name = k.name; span = premise.Ast.at; text = k.written premise; asked = Whether; formula = f
           }
    | _ -> None
  in
  List.filter_map read (Premises.of_check k.formula)

let check_let t env (e : Ast.expr) =
  if not (Laws.can_read t.law_budget env e) then
    if Laws.speaks_of_a_law env e then Laws.check t.c.report t.law_budget env e else ignore (Eval.eval t env e)
