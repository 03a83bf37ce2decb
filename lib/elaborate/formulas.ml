open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus
open Scc_property

let ( let* ) = Option.bind

type t = {
  c : Context.t;
  bodies : Bodies.t;
  composition : Composition.t;
  behaviours : Behaviours.t;
  by_template : (string, int list) Hashtbl.t;  (* indices in the model, in order *)
  numbers : int array;  (* the declared number of each leaf of the model *)
  budget : Typed.budget;
}

let error t ?hint ?near code at fmt = Report.error t.c.report ?hint ?near code at fmt

(* {1 Arguments} *)

(* The one leaf that a name stands for, as an index in the model. *)
let resolve_leaf t (name, at) =
  let number =
    match Registry.find t.bodies.registry name with
    | Some (Leaf i) | Some (Process [ i ]) -> Some i
    | Some (Process _ | Family _) ->
      error t Code.wrong_kind at "`%s` stands for several bodies, and one is expected here" name
        ~hint:"name one of them, or use `forall`, `exists` or `count`";
      None
    | None ->
      error t Code.unknown_name at "unknown process `%s`" name
        ~near:(name, fun () -> Registry.names t.bodies.registry);
      None
  in
  let* i = number in
  if t.composition.index.(i) >= 0 then Some t.composition.index.(i)
  else begin
    error t Code.wrong_kind at "`%s` is not in the network" name;
    None
  end

let leaf t env (e : Ast.expr) =
  match e.it with
  | Path path -> (
      let bound =
        match path.it with
        | [ { name; indices = [] } ] -> Env.find env name.it
        | _ -> None
      in
      match bound with
      | Some (Env.Leaf i) -> Some i
      | Some (Number _ | Truth _ | Macro _) | None ->
        let* name = Composition.single t.c.report env path in
        resolve_leaf t name)
  | _ ->
    error t Code.type_mismatch e.at "the name of a process is expected here";
    None

let known_channel t (name : Ast.name) =
  if Behaviours.has_channel t.behaviours name.it then Some name.it
  else begin
    error t Code.unknown_name name.at "no behaviour or bond of the network has a channel `%s`" name.it
      ~near:(name.it, fun () -> Behaviours.channels t.behaviours);
    None
  end

let channel t (e : Ast.expr) =
  match e.it with
  | Path { it = [ { name; indices = [] } ]; _ } ->
    Option.map (fun a -> (None, a)) (known_channel t name)
  | Co name -> Option.map (fun a -> (Some Behaviour.Co_name, a)) (known_channel t name)
  | _ ->
    error t Code.type_mismatch e.at "the name of a channel is expected here";
    None

let owner t i =
  Option.map
    (fun (l : Bodies.leaf) -> { Behaviours.name = l.name; shape = l.shape; span = l.span })
    t.bodies.leaves.(t.numbers.(i))

(* {1 Atoms} *)

let axes : (string * Property.axis) list = [ ("x", X); ("y", Y); ("z", Z) ]

let one_leaf : (string * (int -> Property.num)) list =
  [
    ("size", fun p -> Property.Size p);
    ("x", fun p -> Property.Position (X, p));
    ("y", fun p -> Property.Position (Y, p));
    ("z", fun p -> Property.Position (Z, p));
    ("vx", fun p -> Property.Velocity (X, p));
    ("vy", fun p -> Property.Velocity (Y, p));
    ("vz", fun p -> Property.Velocity (Z, p));
    ("speed2", fun p -> Property.Speed2 p);
  ]

let two_leaves : (string * (int -> int -> (Property.num, Property.prop) Typed.value)) list =
  [
    ("distance2", fun p q -> Num (Property.Distance2 (p, q)));
    ("bound", fun p q -> Cond (Property.Bound (p, q)));
    ("same", fun p q -> Cond (Property.Same (p, q)));
    ("touching", fun p q -> Cond (Property.Touching (p, q)));
  ]

let constants : (string * (Property.num, Property.prop) Typed.value) list =
  [
    ("processes", Num Property.Processes);
    ("energy", Num Property.Energy);
    ("time", Num Property.Time);
    ("quiescent", Cond Property.Quiescent);
  ]

let functions =
  [ "bonds"; "offers"; "behaviour" ] @ Long_list.map fst one_leaf @ Long_list.map fst two_leaves

let value : (Property.num, Property.prop) Typed.value -> (Property.num, Property.temporal) Typed.value =
  function
  | Num n -> Num n
  | Cond p -> Cond (Property.State p)

let arity t (at : Span.t) name expected given =
  error t Code.bad_arity at "`%s` takes %s, and is given %d" name expected given;
  None

let bonds t env at arguments =
  match arguments with
  | [] -> Some (Typed.Num (Property.Bonds (None, None)))
  | [ a ] ->
    let* _, a = channel t a in
    Some (Typed.Num (Property.Bonds (Some a, None)))
  | [ a; p; q ] ->
    let a = channel t a and p = leaf t env p and q = leaf t env q in
    let* _, a = a in
    let* p, q = Typed.both p q in
    Some (Typed.Num (Property.Bonds (Some a, Some (p, q))))
  | _ -> arity t at "bonds" "a channel, or a channel and two processes" (List.length arguments)

let offers t env at arguments =
  match arguments with
  | [ p; a ] ->
    let* p, (polarity, a) = Typed.both (leaf t env p) (channel t a) in
    Some (Typed.Cond (Property.State (Offers (p, polarity, a))))
  | _ -> arity t at "offers" "a process and a channel" (List.length arguments)

let apply t env (e : Ast.expr) (f : Ast.name) arguments =
  match (f.it, List.assoc_opt f.it one_leaf, List.assoc_opt f.it two_leaves, arguments) with
  | "bonds", _, _, _ -> bonds t env e.at arguments
  | "offers", _, _, _ -> offers t env e.at arguments
  | "behaviour", _, _, _ ->
    error t Code.type_mismatch e.at "a behaviour can only be compared with a name, as in `behaviour(p) = K`";
    None
  | _, Some make, _, [ p ] -> Option.map (fun p -> Typed.Num (make p)) (leaf t env p)
  | name, Some _, _, _ -> arity t e.at name "one process" (List.length arguments)
  | _, None, Some make, [ p; q ] ->
    Option.map (fun (p, q) -> value (make p q)) (Typed.both (leaf t env p) (leaf t env q))
  | name, None, Some _, _ -> arity t e.at name "two processes" (List.length arguments)
  | "round", None, None, _ ->
    error t Code.type_mismatch e.at "`round` of what changes cannot stand in a property";
    None
  | name, None, None, _ ->
    error t Code.unknown_name f.at "unknown function `%s`" name ~near:(name, fun () -> functions);
    None

let variable t env (path : Ast.path) =
  match path.it with
  | [ { name; indices = [] } ] -> (
      match List.assoc_opt name.it constants with
      | Some v -> Some (value v)
      | None ->
        error t Code.unknown_name path.at "unknown name `%s` in a formula" name.it
          ~near:(name.it, fun () -> Long_list.map fst constants @ Env.names env);
        None)
  | [ { name = { it = "momentum"; _ }; indices = [] }; { name; indices = [] } ] -> (
      match List.assoc_opt name.it axes with
      | Some axis -> Some (Num (Property.Momentum axis))
      | None ->
        error t Code.unknown_name name.at "`momentum` has the components x, y and z";
        None)
  | _ ->
    error t Code.type_mismatch path.at "a value is expected here"
      ~hint:"say what of a process is meant, as in `x(p)`";
    None

let is_definition t env negated p (k : Ast.name) =
  let* i = leaf t env p in
  let* owner = owner t i in
  let* k = Behaviours.definition t.behaviours owner k in
  let atom = Property.Behaviour (i, k) in
  Some (Typed.Cond (Property.State (if negated then Not atom else atom)))

(* [behaviour(p) = K], either way round. *)
let comparison t env (op : Ast.binary) (a : Ast.expr) (b : Ast.expr) =
  let negated =
    match op with
    | Eq -> Some false
    | Ne -> Some true
    | Add | Sub | Mul | Div | Lt | Le | Gt | Ge | And | Or | Implies -> None
  in
  match (negated, a.it, b.it) with
  | Some n, Apply ({ it = "behaviour"; _ }, [ p ]), Path { it = [ { name; indices = [] } ]; _ }
  | Some n, Path { it = [ { name; indices = [] } ]; _ }, Apply ({ it = "behaviour"; _ }, [ p ]) ->
    Some (is_definition t env n p name)
  | _ -> None

(* {1 Quantifiers and temporal operators} *)

let range t (name : Ast.name) =
  match (Hashtbl.find_opt t.c.templates name.it, Registry.find t.bodies.registry name.it) with
  | Some template, _ ->
    template.used <- true;
    Some (Option.value ~default:[] (Hashtbl.find_opt t.by_template name.it))
  | None, Some (Leaf i) -> Some [ t.composition.index.(i) ]
  | None, Some (Process list | Family list) ->
    Some (Long_list.map (fun i -> t.composition.index.(i)) (List.sort Int.compare list))
  | None, None ->
    error t Code.unknown_name name.at "unknown template `%s`" name.it
      ~near:(name.it, fun () -> Context.template_names t.c @ Registry.names t.bodies.registry);
    None

let state_of t at = function
  | Property.State p -> Some p
  | _ ->
    error t Code.type_mismatch at "a state predicate is expected here, and this is a temporal formula";
    None

let all options = if List.for_all Option.is_some options then Some (List.filter_map Fun.id options) else None

let states formulas =
  all (Long_list.map (function Property.State p -> Some p | _ -> None) formulas)

let conjunction formulas =
  match states formulas with
  | Some ps -> Property.State (And ps)
  | None -> Temporal_and formulas

let disjunction formulas =
  match states formulas with
  | Some ps -> Property.State (Or ps)
  | None -> Temporal_or formulas

let quantified t eval env (q : Ast.quantifier) (v : Ast.name) template (body : Ast.expr) =
  let* leaves = range t template in
  let instance i =
    let env = Env.add v.it { Env.value = Leaf i; span = v.at; used = false } env in
    match eval env body with
    | Some (Typed.Cond f) -> Some f
    | Some (Typed.Num _) ->
      error t Code.type_mismatch body.at "a truth value is expected here, and this is a number";
      None
    | None -> None
  in
  let* formulas = all (Long_list.map instance (List.filter (fun i -> i >= 0) leaves)) in
  match q with
  | Forall -> Some (Typed.Cond (conjunction formulas))
  | Exists -> Some (Typed.Cond (disjunction formulas))
  | Count ->
    let* ps = all (Long_list.map (state_of t body.at) formulas) in
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
    let* low, high = Typed.both (duration t env a) (duration t env b) in
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

let formula t eval env (e : Ast.expr) =
  match eval env e with
  | Some (Typed.Cond f) -> Some f
  | Some (Typed.Num _) ->
    error t Code.type_mismatch e.at "a formula is expected here, and this is a number";
    None
  | None -> None

let other t eval env (e : Ast.expr) =
  match e.it with
  | Apply ({ it = "round"; _ }, _) when Constant.is_constant env e ->
    Option.map (fun q -> Typed.Num (Property.Const q)) (Constant.number t.c.report env e)
  | Apply (f, arguments) -> apply t env e f arguments
  | Quantified (q, v, template, body) -> quantified t eval env q v template body
  | Temporal (operator, written, f) ->
    let* b, f = Typed.both (bound t env written) (formula t eval env f) in
    Option.map (fun f -> Typed.Cond f) (temporal t e.at operator written b f)
  | Until (q, f, written, g) ->
    let f = formula t eval env f and g = formula t eval env g in
    let* b = bound t env written in
    let* f, g = Typed.both f g in
    Some (Typed.Cond (Property.Until (path_quantifier q, b, f, g)))
  | Co name ->
    error t Code.type_mismatch e.at "`~%s` is a channel, and a value is expected here" name.it;
    None
  | Number _ | True | False | Path _ | Neg _ | Not _ | Binary _ | If _ ->
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

  let negate = function
    | Property.State p -> Property.State (Not p)
    | f -> Temporal_not f

  let conj a b = conjunction [ a; b ]
  let disj a b = disjunction [ a; b ]

  let choose t at c a b = Option.map (fun p -> Property.If (p, a, b)) (state_of t at c)
  let choose_cond c a b = disj (conj c a) (conj (negate c) b)
  let variable = variable
  let comparison = comparison
  let other = other
end

module Eval = Typed.Make (Algebra)

let create (c : Context.t) (bodies : Bodies.t) (composition : Composition.t) behaviours =
  let by_template = Hashtbl.create 16 in
  let all = List.init (Array.length bodies.leaves) Fun.id in
  let numbers = List.filter (fun i -> composition.included.(i)) all in
  let enter i =
    match bodies.leaves.(i) with
    | None -> ()
    | Some l ->
      let label = Shape.label l.shape in
      let others = Option.value ~default:[] (Hashtbl.find_opt by_template label) in
      Hashtbl.replace by_template label (composition.index.(i) :: others)
  in
  List.iter enter (List.rev numbers);
  let budget = Typed.budget () in
  { c; bodies; composition; behaviours; by_template; numbers = Array.of_list numbers; budget }

let check t (k : Program.check) =
  let* f = Eval.cond t k.env k.formula in
  match Formula.state_formula f with
  | Some _ ->
    error t Code.not_a_formula k.formula.at
      "a check needs a temporal operator: this holds or not at an instant"
      ~hint:"write `always …`, `possibly …` or `eventually …`";
    None
  | None ->
    let text = Scc_syntax.Printer.expr k.formula in
    Some { Property.name = k.name; span = k.span; text; formula = f }
