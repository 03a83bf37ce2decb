open Scc_base
open Scc_exact
open Scc_calculus

type t = Known of Rat.t | In of Ranges.range

let text range = Printf.sprintf "`%s`" (Ranges.range_to_string range)

(* The range as far as it has numbers. *)
let of_range report at (r : Ranges.range) =
  let refuse what = Report.error report Code.bad_range at "%s has no numbers: %s" (text r) what in
  match Rat.compare r.low.value r.high.value with
  | c when c < 0 -> Some (In r)
  | 0 when r.low.included && r.high.included -> Some (Known r.low.value)
  | 0 ->
    refuse "its ends are the same, and do not both belong to it";
    None
  | _ ->
    refuse "its first end is the greater one";
    None

let within (inner : Ranges.range) (outer : Ranges.range) =
  let ends c (i : Ranges.bound) (o : Ranges.bound) = c > 0 || (c = 0 && (o.included || not i.included)) in
  ends (Rat.compare inner.low.value outer.low.value) inner.low outer.low
  && ends (Rat.compare outer.high.value inner.high.value) inner.high outer.high

let range report at (declared : Ranges.range) given =
  let outside ?hint what =
    Report.error report Code.bad_range Span.none ?hint "%s is not within %s" what (text declared);
    None
  in
  let excluded q =
    let is (b : Ranges.bound) = (not b.included) && Rat.equal b.value q in
    if is declared.low || is declared.high then Some "a round bracket leaves out its end, and a square one has it"
    else None
  in
  match (of_range report at declared, given) with
  | None, _ -> None
  | Some known, None -> Some known
  | Some _, Some (Overrides.Value q) ->
    if Ranges.mem declared q then Some (Known q)
    else outside ?hint:(excluded q) (Printf.sprintf "`%s = %s`" declared.name (Rat.to_string q))
  | Some _, Some (Within (low, high)) ->
    let narrow = { declared with low; high } in
    Option.bind (of_range report Span.none narrow) (fun known ->
        if within narrow declared then Some known else outside (text narrow))
