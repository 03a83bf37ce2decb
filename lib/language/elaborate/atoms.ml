open Scc_base
open Scc_syntax
open Scc_property
open Subjects

let axes : (string * Property.axis) list = [ ("x", X); ("y", Y); ("z", Z) ]

let quantity make p : (Property.num, Property.prop) Typed.value = Num (Property.Quantity (make p))

let one_leaf : (string * (int -> (Property.num, Property.prop) Typed.value)) list =
  [
    ("size", quantity (fun p -> Property.Size p));
    ("x", quantity (fun p -> Property.Position (X, p)));
    ("y", quantity (fun p -> Property.Position (Y, p)));
    ("z", quantity (fun p -> Property.Position (Z, p)));
    ("vx", quantity (fun p -> Property.Velocity (X, p)));
    ("vy", quantity (fun p -> Property.Velocity (Y, p)));
    ("vz", quantity (fun p -> Property.Velocity (Z, p)));
    ("speed2", quantity (fun p -> Property.Speed2 p));
    ("wx", quantity (fun p -> Property.Spin (X, p)));
    ("wy", quantity (fun p -> Property.Spin (Y, p)));
    ("wz", quantity (fun p -> Property.Spin (Z, p)));
    ("gone", fun p -> Cond (Property.Fact (Gone p)));
    ("spin2", quantity (fun p -> Property.Spin2 p));
  ]

let two_leaves : (string * (int -> int -> (Property.num, Property.prop) Typed.value)) list =
  [
    ("distance2", fun p q -> Num (Property.Quantity (Distance2 (p, q))));
    ("bound", fun p q -> Cond (Property.Fact (Bound (p, q))));
    ("same", fun p q -> Cond (Property.Fact (Same (p, q))));
    ("touching", fun p q -> Cond (Property.Fact (Touching (p, q))));
  ]

let constants : (string * (Property.num, Property.prop) Typed.value) list =
  [
    ("processes", Num (Property.Quantity Processes));
    ("energy", Num (Property.Quantity Energy));
    ("time", Num (Property.Quantity Time));
    ("quiescent", Cond (Property.Fact Quiescent));
  ]

let functions =
  [ "bonds"; "offers"; "behaviour" ] @ List.map fst one_leaf @ List.map fst two_leaves

let words = functions @ List.map fst constants @ [ "momentum"; "angular" ]

let value : (Property.num, Property.prop) Typed.value -> (Property.num, Property.temporal) Typed.value =
  function
  | Num n -> Num n
  | Cond p -> Cond (Property.State p)
  | Vec (x, y, z) -> Vec (x, y, z)

let arity t (at : Span.t) name expected given =
  error t Code.bad_arity at "`%s` takes %s, and is given %d" name expected given;
  None

let bonds t env at arguments =
  let count name ends = Some (Typed.Num (Property.Quantity (Bonds (name, ends)))) in
  match arguments with
  | [] -> count None None
  | [ a ] ->
    let*? _, a = channel t a in
    count (Some a) None
  | [ a; p; q ] ->
    let a = channel t a and p = leaf t env p and q = leaf t env q in
    let*? _, a = a in
    let*? p, q = Typed.both p q in
    count (Some a) (Some (p, q))
  | _ -> arity t at "bonds" "a channel, or a channel and two processes" (List.length arguments)

let offers t env at arguments =
  match arguments with
  | [ p; a ] ->
    let*? p, (polarity, a) = Typed.both (leaf t env p) (channel t a) in
    Some (Typed.Cond (Property.State (Fact (Offers (p, polarity, a)))))
  | _ -> arity t at "offers" "a process and a channel" (List.length arguments)

(* {1 Transitions} *)

let changes : (string * Property.change) list =
  [
    ("bind", Made); ("weak", Released_weakly); ("strong", Released_strongly); ("split", Released);
  ]

let transitions = "absorb" :: "bounce" :: "hit" :: List.map fst changes

let ends t env arguments : Property.ends option =
  match arguments with
  | [] -> Some Any
  | [ p ] -> Option.map (fun p -> Property.One p) (leaf t env p)
  | p :: q :: _ ->
    Option.map (fun (p, q) -> Property.Two (p, q)) (Typed.both (leaf t env p) (leaf t env q))

let event t env at (word : Ast.name) arguments =
  let made e = Some (Typed.Cond (Property.State (Fact (Event e)))) in
  match (word.it, List.assoc_opt word.it changes, arguments) with
  | "bounce", _, ([] | [ _ ] | [ _; _ ]) ->
    let*? ends = ends t env arguments in
    made (Bounce ends)
  | "absorb", _, ([] | [ _ ] | [ _; _ ]) ->
    let*? ends = ends t env arguments in
    made (Absorbed ends)
  | "absorb", _, _ -> arity t at "absorb" "at most two processes" (List.length arguments)
  | "hit", _, [ p ] ->
    let*? p = spot t env p in
    made (Hit (p, None))
  | "hit", _, [ p; q ] ->
    let*? p, q = Typed.both (spot t env p) (spot t env q) in
    made (Hit (p, Some q))
  | "hit", _, _ -> arity t at "hit" "one body or two, or parts of them" (List.length arguments)
  | "bounce", _, _ -> arity t at "bounce" "at most two processes" (List.length arguments)
  | _, Some change, [] -> made (Bond (change, None, Any))
  | _, Some change, a :: (([] | [ _ ] | [ _; _ ]) as rest) ->
    let*? a, ends = Typed.both (bond_name t env a) (ends t env rest) in
    made (Bond (change, Some a, ends))
  | name, Some _, _ ->
    arity t at name "a channel and at most two processes after it" (List.length arguments)
  | name, None, _ ->
    error t Code.unknown_name word.at
      "unknown transition `%s`; it is one of absorb, bind, bounce, hit, weak, strong, split" name
      ~near:(name, fun () -> transitions);
    None

let apply t env (e : Ast.expr) (f : Ast.name) arguments =
  match (f.it, List.assoc_opt f.it one_leaf, List.assoc_opt f.it two_leaves, arguments) with
  | "bonds", _, _, _ -> bonds t env e.at arguments
  | "offers", _, _, _ -> offers t env e.at arguments
  | "behaviour", _, _, _ ->
    error t Code.type_mismatch e.at "a behaviour can only be compared with a name, as in `behaviour(p) = K`";
    None
  | _, Some make, _, [ p ] -> Option.map (fun p -> value (make p)) (leaf t env p)
  | name, Some _, _, _ -> arity t e.at name "one process" (List.length arguments)
  | _, None, Some make, [ p; q ] ->
    Option.map (fun (p, q) -> value (make p q)) (Typed.both (leaf t env p) (leaf t env q))
  | name, None, Some _, _ -> arity t e.at name "two processes" (List.length arguments)
  | "round", None, None, _ ->
    error t Code.type_mismatch e.at "`round` of what changes cannot stand in a property";
    None
  | _, None, None, _ ->
    Typed.unknown_function t.c.report f (functions @ Typed.functions);
    None

(* The words that a formula begins with. *)
let beginnings = [ "possibly"; "always"; "eventually"; "forall"; "exists"; "count"; "event"; "not" ]

(* Of a name that stands alone and is none: a function without its processes, or the first letters of a word. *)
let half_written name ~known =
  if List.mem_assoc name one_leaf then Some (Printf.sprintf "say of which process: `%s(p)`" name)
  else if List.mem_assoc name two_leaves then Some (Printf.sprintf "say of which processes: `%s(p, q)`" name)
  else
    match Typed.without_brackets (("round" :: functions) @ Typed.functions) name with
    | Some hint -> Some hint
    | None when String.length name < 3 || Option.is_some (Scc_base.Diag.suggest name known) -> None
    | None ->
      List.find_opt (fun word -> String.starts_with ~prefix:name word) (beginnings @ words)
      |> Option.map (Printf.sprintf "did you mean `%s`?")

let variable t env (path : Ast.path) =
  match path.it with
  | [ { name; indices = [] } ] -> (
      match List.assoc_opt name.it constants with
      | Some v -> Some (value v)
      | None ->
        let known = List.map fst constants @ Env.names env in
        error t Code.unknown_name path.at "unknown name `%s` in a formula" name.it
          ?hint:(half_written name.it ~known)
          ~near:(name.it, fun () -> known);
        None)
  | [ { name = { it = ("momentum" | "angular") as of_what; _ }; indices = [] }; { name; indices = [] } ] -> (
      match (of_what, List.assoc_opt name.it axes) with
      | "angular", Some axis -> Some (Num (Property.Quantity (Angular axis)))
      | _, Some axis -> Some (Num (Property.Quantity (Momentum axis)))
      | _, None ->
        error t Code.unknown_name name.at "`%s` has the components x, y and z" of_what;
        None)
  | _ ->
    error t Code.type_mismatch path.at "a value is expected here"
      ~hint:"say what of a process is meant, as in `x(p)`";
    None

let is_definition t env negated p k =
  let*? i = leaf t env p in
  let*? owner = owner t i in
  let*? k = Behaviours.definition t.behaviours env owner k in
  let atom = Property.Fact (Behaviour (i, k)) in
  Some (Typed.Cond (Property.State (if negated then Not atom else atom)))

(* [behaviour(p) = K], either way round. *)
let comparison t env (op : Ast.binary) (a : Ast.expr) (b : Ast.expr) =
  let negated =
    match op with
    | Eq -> Some false
    | Ne -> Some true
    | Add | Sub | Mul | Div | Mod | Lt | Le | Gt | Ge | And | Or | Implies -> None
  in
  let compared n p e = 
    match e.Ast.it with
    | Ast.Apply ({ it = "behaviour"; _ }, _) -> None
    | _ -> Option.map (is_definition t env n p) (Subjects.reference_of e)
  in
  match (negated, a.it, b.it) with
  | Some n, Apply ({ it = "behaviour"; _ }, [ p ]), _ -> compared n p b
  | Some n, _, Apply ({ it = "behaviour"; _ }, [ p ]) -> compared n p a
  | _ -> None
