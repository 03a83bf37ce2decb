open Scc_exact
open Scc_calculus
open Scc_chance
open Scc_explain

type value = { pieces : Parametric.piece list; shape : Dependence.shape option }
type values = (Scc_property.Property.side * value) list

(* {1 Numbers} *)

let few_degrees = 12

(* A root of high degree is told by decimals alone; the JSON document has its polynomial. *)
let point (range : Ranges.range) (x : Algebraic.t) =
  match x with
  | Irrational { polynomial; _ } when Polynomial.degree polynomial > few_degrees ->
    let degree = Polynomial.degree polynomial in
    Printf.sprintf "about %s, a root of degree %d" (Algebraic.to_decimal ~digits:12 x) degree
  | Rational _ | Irrational _ -> Algebraic.to_string ~variable:range.name x

let between range ~low ~low_included ~high ~high_included =
  Printf.sprintf "%s%s, %s%s"
    (if low_included then "[" else "(")
    (point range low) (point range high)
    (if high_included then "]" else ")")

let opened (range : Ranges.range) =
  Printf.sprintf "(%s, %s)" (Rat.to_string range.low.value) (Rat.to_string range.high.value)

let of_all (range : Ranges.range) = Printf.sprintf "%s in %s" range.name (opened range)

(* {1 Functions} *)

let longest = 160

let shortened ~full variable f =
  let text = Rational_function.to_string ~variable f in
  if full || String.length text <= longest then text
  else
    let degree p = Polynomial.degree p in
    let n = degree (Rational_function.numerator f) and d = degree (Rational_function.denominator f) in
    if d = 0 then Printf.sprintf "a polynomial in %s of degree %d" variable n
    else Printf.sprintf "a quotient of polynomials in %s of degrees %d and %d" variable n d

let formula ~full variable : Parametric.value -> string = function
  | Finite f -> shortened ~full variable f
  | Infinite -> "infinite"

let same_pieces a b =
  List.equal
    (fun (p : Parametric.piece) (q : Parametric.piece) ->
       Algebraic.equal p.high q.high
       &&
       match (p.value, q.value) with
       | Finite f, Finite g -> Rational_function.equal f g
       | Infinite, Infinite -> true
       | Finite _, Infinite | Infinite, Finite _ -> false)
    a b

(* Where least and greatest are the same, one of them is told. *)
let distinct (values : values) =
  match values with
  | (_, first) :: rest when List.for_all (fun (_, v) -> same_pieces first.pieces v.pieces) rest ->
    [ (None, first) ]
  | _ -> List.map (fun (s, v) -> (Some s, v)) values

let in_one_line (range : Ranges.range) { pieces; _ } =
  match pieces with
  | [ p ] -> formula ~full:false range.name p.value
  | _ -> Printf.sprintf "%d functions of %s" (List.length pieces) range.name

let to_string range ~values ~holds =
  let { Ranges.low; high; _ } = range in
  let parts set = Dependence.intervals ~low:low.value ~high:high.value set in
  match holds with
  | Some set -> (
      match (parts set, parts (Dependence.complement set)) with
      | _, [] -> Printf.sprintf "holds (exhaustive, all %s)" (of_all range)
      | [], _ -> Printf.sprintf "violated for all %s" (of_all range)
      | _, _ -> Printf.sprintf "violated for some %s" (of_all range))
  | None ->
    let told = function
      | None, v -> in_one_line range v
      | Some side, v -> Likelihoods.side side ^ " " ^ in_one_line range v
    in
    Printf.sprintf "%s, for %s" (String.concat "; " (List.map told (distinct values))) (of_all range)

(* {1 What was found of a function} *)

let most_values = 4

let found (range : Ranges.range) ({ pieces; values } : Parametric.found) =
  let of_piece (p : Parametric.piece) =
    Printf.sprintf "for %s in %s it is %s" range.name
      (between range ~low:p.low ~low_included:false ~high:p.high ~high_included:false)
      (formula ~full:false range.name p.value)
  in
  let of_value (x, y) = Printf.sprintf "%s at %s = %s" (Likelihoods.number y) range.name (Rat.to_string x) in
  let single =
    match values with
    | [] -> []
    | _ ->
      let shown = List.map of_value (List.filteri (fun i _ -> i < most_values) values) in
      let more = List.length values - List.length shown in
      let rest = if more > 0 then [ Printf.sprintf "%d more values were found" more ] else [] in
      [ "it is " ^ String.concat ", " (shown @ rest) ]
  in
  List.map of_piece pieces @ single

(* {1 Lines} *)

let indent = List.map (fun l -> "  " ^ l)

let where (range : Ranges.range) set =
  let { Ranges.low; high; _ } = range in
  let text ({ low; low_included; high; high_included } : Dependence.interval) =
    if low_included && high_included && Algebraic.equal low high then
      Printf.sprintf "%s = %s" range.name (point range low)
    else Printf.sprintf "%s in %s" range.name (between range ~low ~low_included ~high ~high_included)
  in
  match Dependence.intervals ~low:low.value ~high:high.value set with
  | [] -> [ "holds nowhere in this range" ]
  | all -> "holds where" :: indent (List.map text all)

let extreme (range : Ranges.range) what (e : Dependence.extreme) =
  let places = String.concat " or " (List.map (point range) e.at) in
  let told level =
    if e.attained then Printf.sprintf "%s at %s = %s" level range.name places
    else Printf.sprintf "towards %s, as %s goes to %s" level range.name places
  in
  let text =
    match e.level with
    | Exactly x -> told (Likelihoods.number x)
    | Between (low, high) -> told ("about " ^ Decimal.padded ~places:9 (Rat.middle low high))
    | Unbounded -> Printf.sprintf "beyond all bounds, as %s goes to %s" range.name places
  in
  Printf.sprintf "%s over %s: %s" what range.name text

let trend (range : Ranges.range) (low, high, t) =
  let word = match (t : Dependence.trend) with Rises -> "rises" | Falls -> "falls" | Constant -> "is constant" in
  Printf.sprintf "%s for %s in %s" word range.name
    (between range ~low ~low_included:false ~high ~high_included:false)

let function_lines ~full (range : Ranges.range) { pieces; shape } =
  let of_piece (p : Parametric.piece) =
    let part =
      match pieces with
      | [ _ ] -> ""
      | _ ->
        Printf.sprintf "for %s in %s: " range.name
          (between range ~low:p.low ~low_included:false ~high:p.high ~high_included:false)
    in
    let derivative =
      match p.value with
      | Infinite -> []
      | Finite f when Option.is_some (Rational_function.to_constant f) -> []
      | Finite f ->
        let text = Rational_function.to_string ~variable:range.name f in
        if (not full) && String.length text > longest then []
        else [ "derivative: " ^ shortened ~full range.name (Rational_function.derivative f) ]
    in
    (part ^ formula ~full range.name p.value) :: (if part = "" then derivative else indent derivative)
  in
  let shape_lines ({ trends; extremes } : Dependence.shape) =
    let ends =
      match extremes with
      | None -> []
      | Some (least, greatest) -> [ extreme range "least" least; extreme range "greatest" greatest ]
    in
    List.map (trend range) trends @ ends
  in
  List.concat_map of_piece pieces @ Option.fold ~none:[] ~some:shape_lines shape

let lines ~full (range : Ranges.range) ~values ~holds =
  let of_value (side, value) =
    let side = Option.fold ~none:"" ~some:(fun s -> Likelihoods.side s ^ ", ") side in
    (side ^ "as a function of " ^ range.name) :: indent (function_lines ~full range value)
  in
  Option.fold ~none:[] ~some:(where range) holds @ List.concat_map of_value (distinct values)
