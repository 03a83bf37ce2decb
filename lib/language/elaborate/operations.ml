open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus
open Algebra

let both a b =
  match (a, b) with
  | Some a, Some b -> Some (a, b)
  | _, _ -> None

let functions = [ "abs"; "ceil"; "cross"; "dot"; "floor"; "max"; "min"; "mod"; "sign" ]

let described = function
  | Num _ -> "a number"
  | Cond _ -> "a truth value"
  | Vec _ -> "a vector"

let unknown_function report (f : Ast.name) known =
  let known = List.sort String.compare known in
  Report.error report Code.unknown_name f.at "unknown function `%s`; those that can stand here are %s" f.it
    (String.concat ", " known)
    ~near:(f.it, fun () -> known)

(* How often an argument of a function is written out where it is no constant. *)
let copies = function
  | "min" | "max" | "sign" | "cross" -> 2
  | "abs" -> 3
  | "floor" | "ceil" -> 4
  | "mod" -> 5
  | _ -> 1

let takes = function
  | "min" | "max" -> "numbers, one or more"
  | "dot" | "cross" -> "two vectors"
  | "mod" -> "two numbers"
  | _ -> "one number"

module Make (A : Algebra.S) = struct
  let error ctx ?hint code span fmt = Report.error (A.report ctx) ?hint code span fmt

  let as_num ctx at = function
    | None -> None
    | Some (Num n) -> Some n
    | Some ((Cond _ | Vec _) as v) ->
      error ctx Code.type_mismatch at "a number is expected here, and this is %s" (described v);
      None

  let as_cond ctx at = function
    | None -> None
    | Some (Cond c) -> Some c
    | Some ((Num _ | Vec _) as v) ->
      error ctx Code.type_mismatch at "a truth value is expected here, and this is %s" (described v);
      None

  let as_vec ctx at = function
    | None -> None
    | Some (Vec (x, y, z)) -> Some (x, y, z)
    | Some ((Num _ | Cond _) as v) ->
      error ctx Code.type_mismatch at "a vector is expected here, and this is %s" (described v);
      None

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
      | Mod | Lt | Le | Gt | Ge | Eq | Ne | And | Or | Implies ->
        Bug.fail __POS__ "not an arithmetic operator"
    in
    match (op, A.constant a, A.constant b) with
    | Div, _, Some d when Rat.sign d = 0 ->
      error ctx Code.division_by_zero at "division by zero";
      None
    | _, Some p, Some q -> fold ctx at exact p q
    | _ -> if A.admits ctx at op a b then Some (general a b) else None

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
    | Add | Sub | Mul | Div | Mod | Lt | Le | Gt | Ge | Eq | Ne -> Bug.fail __POS__ "not a connective"

  let comparison_of : Ast.binary -> Law.comparison option = function
    | Lt -> Some Law.Lt
    | Le -> Some Law.Le
    | Gt -> Some Law.Gt
    | Ge -> Some Law.Ge
    | Eq -> Some Law.Eq
    | Ne -> Some Law.Ne
    | Add | Sub | Mul | Div | Mod | And | Or | Implies -> None

  (* {2 Functions}

     Written with the operators, so that each algebra has them: min(a, b) is if a <= b then a else b. *)

  let zero = A.const Rat.zero
  let one = A.const Rat.one
  let negated n = match A.constant n with Some q -> A.const (Rat.neg q) | None -> A.neg n

  let choose ctx at c a b =
    match A.truth c with
    | Some t -> Some (if t then a else b)
    | None -> A.choose ctx at c a b

  let smaller ctx at a b = choose ctx at (compare Le a b) a b
  let greater ctx at a b = choose ctx at (compare Ge a b) a b
  let abs ctx at a = choose ctx at (compare Ge a zero) a (negated a)

  let sign ctx at a =
    let*? below = choose ctx at (compare Lt a zero) (negated one) zero in
    choose ctx at (compare Gt a zero) one below

  (* From the nearest integer, which is at most one beside it. *)
  let integer ctx (at : Span.t) what a beyond (step : Ast.binary) =
    let nearest =
      match A.constant a with
      | Some q -> Some (A.const (Rat.round_to q ~quantum:Rat.one))
      | None -> A.nearest ctx at what a
    in
    let*? n = nearest in
    let*? beside = arithmetic ctx at step n one in
    choose ctx at (compare beyond n a) beside n

  let floor ctx at what a = integer ctx at what a Law.Gt Sub
  let ceil ctx at what a = integer ctx at what a Law.Lt Add

  (* a - b*floor(a/b). *)
  let modulo ctx at a b =
    let*? quotient = arithmetic ctx at Div a b in
    let*? whole = floor ctx at "mod" quotient in
    let*? below = arithmetic ctx at Mul b whole in
    arithmetic ctx at Sub a below

  let dot ctx at (a, b, c) (x, y, z) =
    let*? p, q = both (arithmetic ctx at Mul a x) (arithmetic ctx at Mul b y) in
    let*? r, s = both (arithmetic ctx at Mul c z) (arithmetic ctx at Add p q) in
    arithmetic ctx at Add s r

  let cross ctx at (a, b, c) (x, y, z) =
    let minor p q r s =
      let*? m, n = both (arithmetic ctx at Mul p s) (arithmetic ctx at Mul q r) in
      arithmetic ctx at Sub m n
    in
    let*? u, v = both (minor b c y z) (minor c a z x) in
    let*? w = minor a b x y in
    Some (Vec (u, v, w))

  let each f (a, b, c) (x, y, z) =
    let*? u, v = both (f a x) (f b y) in
    let*? w = f c z in
    Some (Vec (u, v, w))

  let is_constant = function
    | Num n -> Option.is_some (A.constant n)
    | Cond c -> Option.is_some (A.truth c)
    | Vec (x, y, z) -> List.for_all (fun n -> Option.is_some (A.constant n)) [ x; y; z ]

  let num n = Option.map (fun n -> Num n) n

  (* Of numbers and vectors. *)
  let operate ctx at (op : Ast.binary) a b =
    match (op, a, b) with
    | Mod, Num x, Num y -> num (modulo ctx at x y)
    | _, Num x, Num y -> num (arithmetic ctx at op x y)
    | (Add | Sub), Vec (a, b, c), Vec (x, y, z) -> each (arithmetic ctx at op) (a, b, c) (x, y, z)
    | Mul, Num k, Vec (x, y, z) -> each (arithmetic ctx at op) (k, k, k) (x, y, z)
    | (Mul | Div), Vec (x, y, z), Num k -> each (arithmetic ctx at op) (x, y, z) (k, k, k)
    | _ ->
      let verb =
        match op with
        | Add -> "added"
        | Sub -> "subtracted"
        | Mul -> "multiplied"
        | _ -> "divided"
      in
      let hint =
        match (a, b) with
        | Vec _, Vec _ -> Some "the products of vectors are `dot(v, w)` and `cross(v, w)`"
        | _ -> None
      in
      error ctx ?hint Code.type_mismatch at "%s and %s cannot be %s" (described a) (described b) verb;
      None

  let wrong_arity ctx at name = error ctx Code.bad_arity at "`%s` takes %s" name (takes name)

  let check_arity ctx at name n =
    let fits =
      match name with
      | "min" | "max" -> n > 0
      | "mod" | "dot" | "cross" -> n = 2
      | _ -> n = 1
    in
    if not fits then wrong_arity ctx at name

  let call ctx (at : Span.t) name arguments =
    let wrong () =
      wrong_arity ctx at name;
      None
    in
    let rec fold f = function
      | [ Num n ] -> Some (Num n)
      | Num a :: Num b :: rest ->
        let*? n = f ctx at a b in
        fold f (Num n :: rest)
      | _ -> wrong ()
    in
    match (name, arguments) with
    | "min", _ -> fold smaller arguments
    | "max", _ -> fold greater arguments
    | "abs", [ Num a ] -> num (abs ctx at a)
    | "sign", [ Num a ] -> num (sign ctx at a)
    | "floor", [ Num a ] -> num (floor ctx at name a)
    | "ceil", [ Num a ] -> num (ceil ctx at name a)
    | "mod", [ Num a; Num b ] -> num (modulo ctx at a b)
    | "dot", [ Vec (a, b, c); Vec (x, y, z) ] -> num (dot ctx at (a, b, c) (x, y, z))
    | "cross", [ Vec (a, b, c); Vec (x, y, z) ] -> cross ctx at (a, b, c) (x, y, z)
    | _ -> wrong ()

  let all options =
    if List.for_all Option.is_some options then Some (List.filter_map Fun.id options) else None
end
