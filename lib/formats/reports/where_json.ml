open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_regions
open Scc_json
open Scc_runs
open Json_format

let named name text t = named ~file:Shared.file name (about text t)

(* {1 Constraints, with the names of variables} *)

let coefficients =
  let terms (name, numbers) =
    let term i a = if Rat.sign a = 0 then [] else [ (name i, a) ] in
    List.concat (Array.to_list (Array.mapi term numbers))
  in
  from terms (entries Shared.rational)

let relation : Constraint.relation -> string = function
  | Less -> "<"
  | At_most -> "<="
  | Equal -> "="

let constraint_format =
  fields
    [
      field "coefficients" coefficients (fun (name, (c : Constraint.t)) -> (name, Array.map Q.of_bigint c.normal));
      field "relation" (word relation [ Less; At_most; Equal ]) (fun (_, (c : Constraint.t)) -> c.relation);
      field "bound" Shared.rational (fun (_, (c : Constraint.t)) -> Q.of_bigint c.right);
    ]

let polyhedron_format =
  let named_constraints (name, p) = List.map (fun c -> (name, c)) (Polyhedron.constraints p) in
  list constraint_format |> from named_constraints |> checked
  |> named "polyhedron"
    "The points that satisfy all these linear constraints over parameters; of none, all points. Coefficients \
     that are 0 are left out."

let form_format =
  fields
    [
      field "coefficients" coefficients (fun (name, (f : Linear.t)) -> (name, f.coefficients));
      field "constant" Shared.rational (fun (_, (f : Linear.t)) -> f.constant);
    ]
  |> named "form"
    "The sum of the constant and of the variables with their coefficients, of which those that are 0 are left out."


(* {1 Sets of values of parameters} *)

let measure =
  named "measure" "The volume of the pieces; null where it is not computed, as one of them has too many corners."
    (nullable Shared.rational)

let set_fields =
  let pieces (ranges, u, _) = List.map (fun p -> (Ranges.name ranges, p)) (Union.pieces u) in
  all
    [
      field "pieces" (list polyhedron_format) pieces; field "measure" measure (fun (_, _, measure) -> measure);
    ]

let set =
  obj set_fields
  |> named "set"
    "A set of values of parameters, as disjoint polyhedra, and its volume. It is empty if it has no pieces, \
     not if its volume is 0."

let probability =
  let bounds : Where.probability -> Rat.t list option = function
    | Exactly _ -> None
    | Between (low, high) -> Some [ low; high ]
    | Not_computed -> Some [ Rat.zero; Rat.one ]
  in
  let exactly : Where.probability -> Rat.t option = function
    | Exactly x -> Some x
    | Between _ | Not_computed -> None
  in
  all
    [
      field "probability" (nullable Shared.rational) exactly
        ~about:"The volume over that of the range; null where volume is left unknown or not computed.";
      maybe "probability_between" (list ~least:2 ~most:2 Shared.rational) bounds
        ~about:
          "Where the probability is null: what it is if it fails wherever that is left unknown, and if it \
           holds there; 0 and 1 where volume is not computed.";
    ]

let format =
  let names ((w : Where.t), _) = List.map (fun (r : Ranges.range) -> r.name) (Array.to_list w.ranges) in
  let part set measure ((w : Where.t), measures) = (w.ranges, set w, measure measures) in
  let holds = part (fun w -> w.holds) (fun (m : Where.measures) -> m.of_holds) in
  let fails = part (fun w -> w.fails) (fun (m : Where.measures) -> m.of_fails) in
  let unknown = part (fun w -> w.unknown) (fun (m : Where.measures) -> m.of_unknown) in
  from (fun w -> (w, Where.measures w))
    (fields
       [
         field "parameters" (list ~distinct:true some_text) names;
         within holds set_fields;
         within (fun (w, _) -> Where.probability w) probability;
         field "range" polyhedron_format (fun ((w : Where.t), _) ->
             (Ranges.name w.ranges, Ranges.box w.ranges))
           ~about:"All values that the parameters may have.";
         field "fails" set fails ~about:"Where it fails.";
         field "unknown" set unknown ~about:"The rest of the range.";
       ])
  |> named "where"
    "For which values of the parameters that have ranges something holds: the pieces, which are disjoint."

let where = write format

(* {1 Probabilities as functions of parameters} *)

let ends =
  all
    [
      field "low" (nullable Shared.rational) (fun (e : Chances.ends) -> e.low);
      field "high" (nullable Shared.rational) (fun (e : Chances.ends) -> e.high);
    ]

(* An end that is not the same all over. *)
let form_of end_ ((ranges : Ranges.t), (p : Chances.part)) =
  match end_ p.value with
  | Some f when not (Linear.is_constant f) -> Some (Ranges.name ranges, f)
  | Some _ | None -> None

let part =
  fields
    [
      within (fun (_, p) -> Chances.ends_of p) ends;
      maybe "low_form" form_format (form_of (fun (v : Chances.value) -> v.least))
        ~about:"Of a mean, if its lower bound depends on the parameters: as a function of them.";
      maybe "high_form" form_format (form_of (fun (v : Chances.value) -> v.most))
        ~about:"Of a mean, if its upper bound depends on the parameters: as a function of them.";
      within (fun (ranges, (p : Chances.part)) -> (ranges, p.set, Where.measure p.set)) set_fields;
    ]
  |> named "part"
    "A probability, where low and high are one, or proved bounds of it; or a mean, with its bounds over the part. \
     A mean without a low is infinite, and without a high alone no upper bound is known. And the values of the \
     parameters for which it is so, as disjoint polyhedra with their volume."

type chances = { chances : Chances.t; with_parts : bool }

let chances_fields =
  let mean c =
    match Chances.mean c.chances with Between ends -> Some ends | Not_known _ | Not_computed -> None
  in
  let unknown { chances = c; _ } =
    if Chances.known_everywhere c then None else Some (c.ranges, c.unknown, Where.measure c.unknown)
  in
  let parts c =
    if c.with_parts then Some (List.map (fun p -> (c.chances.Chances.ranges, p)) c.chances.parts) else None
  in
  all
    [
      within (fun c -> Chances.extremes c.chances) ends;
      field "mean" (nullable (obj ends)) mean
        ~about:
          "Over parameters that are independent and uniform in their ranges; null where a volume is not computed, \
           or if `unknown` has a volume.";
      maybe "parts" (list ~least:1 part) parts
        ~about:
          "With --where: each value with the parameters that have it. With `unknown` the parts make up the whole \
           range.";
      maybe "unknown" set unknown
        ~about:
          "Of a number at a time: for which values of the parameters nothing is known of its mean, as where the \
           number has no value. Left out if there are none. Then low and high are those of all others.";
    ]
