open Scc_exact
open Scc_chance
open Scc_verify
open Scc_json
open Scc_runs
open Json_format

let named name text t = named ~file:Shared.file name (about text t)

(* {1 Numbers} *)

let polynomial = from Polynomial.coefficients (list Shared.rational)

let point =
  let rational a = match (a : Algebraic.t) with Rational r -> Some r | Irrational _ -> None in
  let irrational a =
    match (a : Algebraic.t) with
    | Rational _ -> None
    | Irrational { polynomial; low; high } -> Some (polynomial, low, high)
  in
  let root =
    fields
      [
        field "root_of" polynomial (fun (p, _, _) -> p);
        field "low" Shared.rational (fun (_, low, _) -> low);
        field "high" Shared.rational (fun (_, _, high) -> high);
      ]
  in
  union [ case Shared.rational rational ignore; case root irrational ignore ]
  |> named "point"
    "A real number: a rational, or the only root of a polynomial between low and high, which is irrational. \
     Coefficients of polynomials are from the constant one up."

let function_fields =
  all
    [
      field "numerator" polynomial Rational_function.numerator;
      field "denominator" polynomial Rational_function.denominator;
    ]

let piece =
  fields
    [
      field "low" point (fun (p : Parametric.piece) -> p.low);
      field "high" point (fun (p : Parametric.piece) -> p.high);
      field "function" (nullable (obj function_fields)) (fun (p : Parametric.piece) ->
          match p.value with Finite f -> Some f | Infinite -> None)
        ~about:"In lowest terms; null for an infinite value.";
    ]

(* {1 Shapes} *)

let trend =
  let word_of : Dependence.trend -> string = function
    | Rises -> "rises"
    | Falls -> "falls"
    | Constant -> "constant"
  in
  fields
    [
      field "low" point (fun (low, _, _) -> low);
      field "high" point (fun (_, high, _) -> high);
      field "trend" (word word_of [ Dependence.Rises; Falls; Constant ]) (fun (_, _, t) -> t);
    ]

let extreme =
  let level (e : Dependence.extreme) =
    match e.level with Exactly x -> Some (x, x) | Between (low, high) -> Some (low, high) | Unbounded -> None
  in
  fields
    [
      field "at" (list ~least:1 point) (fun (e : Dependence.extreme) -> e.at)
        ~about:"All points at which it may be: no bounds of the values there tell them apart.";
      field "attained" bool (fun (e : Dependence.extreme) -> e.attained)
        ~about:"False if it is the limit at an end of the range.";
      field "value"
        (nullable
           (fields [ field "low" Shared.rational fst; field "high" Shared.rational snd ]))
        level
        ~about:"Exactly, where low and high are one; else bounds of it. Null if it grows beyond all bounds.";
    ]

let shape (v : Depending.value) f = Option.bind v.shape f
let extremes (v : Depending.value) pick = shape v (fun s -> Option.map pick s.extremes)
let side : Scc_property.Property.side -> string = function Least -> "least" | Greatest -> "greatest"

let value =
  fields
    [
      field "side" (word side [ Scc_property.Property.Least; Greatest ]) fst
        ~about:"Over the choices of all schedulers, for each value of the parameter.";
      field "pieces" (list ~least:1 piece) (fun (_, (v : Depending.value)) -> v.pieces)
        ~about:"Where two pieces meet, both functions have one value.";
      maybe "trends" (list ~least:1 trend) (fun (_, v) -> shape v (fun s -> Some s.trends));
      maybe "least" extreme (fun (_, v) -> extremes v fst);
      maybe "greatest" extreme (fun (_, v) -> extremes v snd);
    ]

let interval =
  fields
    [
      field "low" point (fun (i : Dependence.interval) -> i.low);
      field "low_included" bool (fun (i : Dependence.interval) -> i.low_included);
      field "high" point (fun (i : Dependence.interval) -> i.high);
      field "high_included" bool (fun (i : Dependence.interval) -> i.high_included);
    ]

let intervals (d : Verdict.dependence) =
  let low = d.parameter.low.value and high = d.parameter.high.value in
  Option.map (Dependence.intervals ~low ~high) d.holds

let format =
  fields
    [
      field "parameter" some_text (fun (d : Verdict.dependence) -> d.parameter.name);
      field "low" Shared.rational (fun (d : Verdict.dependence) -> d.parameter.low.value);
      field "high" Shared.rational (fun (d : Verdict.dependence) -> d.parameter.high.value);
      maybe "holds" (list interval) intervals
        ~about:"Of a claim: for which values it holds, disjoint and increasing.";
      maybe "functions" (list ~least:1 ~most:2 value) (fun (d : Verdict.dependence) ->
          match d.values with [] -> None | _ :: _ as values -> Some values)
        ~about:"The probability or the mean; of a claim, the one that it tests, if it is a single test.";
    ]
  |> named "dependence" "How an answer depends on a parameter, for its values strictly between low and high."
