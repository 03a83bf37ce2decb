open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

type ('n, 'c) value = Num of 'n | Cond of 'c
type budget = { mutable left : int; mutable spent_on : Span.t }

let budget () = { left = Limits.terms; spent_on = Span.none }

module type ALGEBRA = sig
  type context
  type num
  type cond

  val report : context -> Report.t
  val budget : context -> budget
  val const : Rat.t -> num
  val constant : num -> Rat.t option
  val neg : num -> num
  val add : num -> num -> num
  val sub : num -> num -> num
  val mul : num -> num -> num
  val div : num -> num -> num
  val bool : bool -> cond
  val truth : cond -> bool option
  val compare : Law.comparison -> num -> num -> cond
  val negate : cond -> cond
  val conj : cond -> cond -> cond
  val disj : cond -> cond -> cond
  val choose : context -> Span.t -> cond -> num -> num -> num option
  val choose_cond : cond -> cond -> cond -> cond
  val variable : context -> Env.t -> Ast.path -> (num, cond) value option

  val comparison :
    context -> Env.t -> Ast.binary -> Ast.expr -> Ast.expr -> (num, cond) value option option

  val other :
    context ->
    (Env.t -> Ast.expr -> (num, cond) value option) ->
    Env.t ->
    Ast.expr ->
    (num, cond) value option
end

let both a b =
  match (a, b) with
  | Some a, Some b -> Some (a, b)
  | _, _ -> None

module Make (A : ALGEBRA) = struct
  let error ctx ?hint code span fmt = Report.error (A.report ctx) ?hint code span fmt
  let ( let* ) = Option.bind

  let as_num ctx at = function
    | None -> None
    | Some (Num n) -> Some n
    | Some (Cond _) ->
      error ctx Code.type_mismatch at "a number is expected here, and this is a truth value";
      None

  let as_cond ctx at = function
    | None -> None
    | Some (Cond c) -> Some c
    | Some (Num _) ->
      error ctx Code.type_mismatch at "a truth value is expected here, and this is a number";
      None

  let spend ctx =
    let budget = A.budget ctx in
    budget.left <- budget.left - 1;
    if budget.left = 0 then
      error ctx Code.too_deep budget.spent_on
        "the laws and formulas of the model have more than %d terms, written out"
        Limits.terms;
    budget.left > 0

  (* An exact operation on constants. The size of what it makes is bounded beforehand by the sizes of what it
     is made of. *)
  let fold ctx at operation a b =
    if Rat.bits a + Rat.bits b > Limits.number_bits then begin
      error ctx Code.number_too_large at "this constant is too large (more than %d bits)"
        Limits.number_bits;
      None
    end
    else Some (A.const (operation a b))

  let arithmetic ctx at (op : Ast.binary) a b =
    let exact, general =
      match op with
      | Add -> (Rat.add, A.add)
      | Sub -> (Rat.sub, A.sub)
      | Mul -> (Rat.mul, A.mul)
      | Div -> (Rat.div, A.div)
      | Lt | Le | Gt | Ge | Eq | Ne | And | Or | Implies -> Bug.fail __POS__ "not an arithmetic operator"
    in
    match (op, A.constant a, A.constant b) with
    | Div, _, Some d when Rat.sign d = 0 ->
      error ctx Code.division_by_zero at "division by zero";
      None
    | _, Some p, Some q -> fold ctx at exact p q
    | _ -> Some (general a b)

  let compare comparison a b =
    match (A.constant a, A.constant b) with
    | Some p, Some q -> A.bool (Law.compare_rationals comparison p q)
    | _ -> A.compare comparison a b

  let negate c =
    match A.truth c with
    | Some b -> A.bool (not b)
    | None -> A.negate c

  let conj a b =
    match (A.truth a, A.truth b) with
    | Some false, _ | _, Some false -> A.bool false
    | Some true, _ -> b
    | _, Some true -> a
    | None, None -> A.conj a b

  let disj a b =
    match (A.truth a, A.truth b) with
    | Some true, _ | _, Some true -> A.bool true
    | Some false, _ -> b
    | _, Some false -> a
    | None, None -> A.disj a b

  let connective (op : Ast.binary) a b =
    match op with
    | And -> conj a b
    | Or -> disj a b
    | Implies -> disj (negate a) b
    | Add | Sub | Mul | Div | Lt | Le | Gt | Ge | Eq | Ne -> Bug.fail __POS__ "not a connective"

  let comparison_of : Ast.binary -> Law.comparison option = function
    | Lt -> Some Law.Lt
    | Le -> Some Law.Le
    | Gt -> Some Law.Gt
    | Ge -> Some Law.Ge
    | Eq -> Some Law.Eq
    | Ne -> Some Law.Ne
    | Add | Sub | Mul | Div | And | Or | Implies -> None

  let rec at_depth ctx depth env (e : Ast.expr) =
    if depth > Limits.depth then begin
      error ctx Code.too_deep e.at "this nests more than %d levels deep, with its `let`s" Limits.depth;
      None
    end
    else if not (spend ctx) then None
    else
      match e.it with
      | Number q -> Some (Num (A.const q))
      | True -> Some (Cond (A.bool true))
      | False -> Some (Cond (A.bool false))
      | Path path -> name ctx depth env path
      | Neg a ->
        let* n = num_at ctx (depth + 1) env a in
        Some (Num (match A.constant n with Some q -> A.const (Rat.neg q) | None -> A.neg n))
      | Not a -> Option.map (fun c -> Cond (negate c)) (cond_at ctx (depth + 1) env a)
      | Binary (op, a, b) -> binary ctx depth env e.at op a b
      | If (c, a, b) -> conditional ctx depth env c a b
      | Apply _ | Co _ | Quantified _ | Temporal _ | Until _ | Leads_to _ | Event _ ->
        A.other ctx (at_depth ctx (depth + 1)) env e

  and num_at ctx depth env (e : Ast.expr) = as_num ctx e.at (at_depth ctx depth env e)
  and cond_at ctx depth env (e : Ast.expr) = as_cond ctx e.at (at_depth ctx depth env e)

  and name ctx depth env (path : Ast.path) =
    match path.it with
    | [ { name; indices = [] } ] -> (
        match Env.find env name.it with
        | Some (Number q) -> Some (Num (A.const q))
        | Some (Truth b) -> Some (Cond (A.bool b))
        | Some (Macro (body, scope)) -> at_depth ctx (depth + 1) scope body
        | Some (Leaf _) ->
          error ctx Code.wrong_kind path.at "`%s` stands for a process, and a value is expected here" name.it
            ~hint:(Printf.sprintf "say what of it is meant, as in `x(%s)`" name.it);
          None
        | None -> A.variable ctx env path)
    | _ -> A.variable ctx env path

  and binary ctx depth env at op a b =
    match op with
    | Add | Sub | Mul | Div ->
      let* x, y = both (num_at ctx (depth + 1) env a) (num_at ctx (depth + 1) env b) in
      Option.map (fun n -> Num n) (arithmetic ctx at op x y)
    | And | Or | Implies ->
      let* x, y = both (cond_at ctx (depth + 1) env a) (cond_at ctx (depth + 1) env b) in
      Some (Cond (connective op x y))
    | Lt | Le | Gt | Ge | Eq | Ne -> (
        match (A.comparison ctx env op a b, comparison_of op) with
        | Some result, _ -> result
        | None, Some c ->
          let* x, y = both (num_at ctx (depth + 1) env a) (num_at ctx (depth + 1) env b) in
          Some (Cond (compare c x y))
        | None, None -> Bug.fail __POS__ "not a comparison")

  and conditional ctx depth env c a b =
    let below = at_depth ctx (depth + 1) env in
    let condition = cond_at ctx (depth + 1) env c in
    let branches = both (below a) (below b) in
    let* condition = condition in
    match branches with
    | None -> None
    | Some (Num x, Num y) -> (
        match A.truth condition with
        | Some t -> Some (Num (if t then x else y))
        | None -> Option.map (fun n -> Num n) (A.choose ctx c.at condition x y))
    | Some (Cond x, Cond y) -> (
        match A.truth condition with
        | Some t -> Some (Cond (if t then x else y))
        | None ->
          (* What is made has the condition twice: read again, it is counted twice. Otherwise conditions
             within conditions would make terms beyond every limit. *)
          let* _ = cond_at ctx (depth + 1) env c in
          Some (Cond (A.choose_cond condition x y)))
    | Some (Num _, Cond _) | Some (Cond _, Num _) ->
      error ctx Code.type_mismatch b.at "the branches of `if` are a number and a truth value";
      None

  let eval ctx env (e : Ast.expr) =
    (A.budget ctx).spent_on <- e.at;
    at_depth ctx 0 env e

  let num ctx env (e : Ast.expr) = as_num ctx e.at (eval ctx env e)
  let cond ctx env (e : Ast.expr) = as_cond ctx e.at (eval ctx env e)
end
