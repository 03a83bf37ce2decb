open Scc_exact
open Scc_syntax

let numbers report env (v : Ast.name) (r : Ast.bounds) =
  let integer = Constant.integer report env "the bound of a range" in
  let*? low, high = Typed.both (integer r.low) (integer r.high) in
  if Z.compare (Z.sub high low) (Z.of_int Limits.items) > 0 then begin
    Report.error report Scc_base.Code.too_deep r.high.at "this range has more than %d numbers" Limits.items;
    None
  end
  else
    let rec from i found =
      if Z.compare i high > 0 then Some (List.rev found)
      else
        let value = Env.Number (Rat.make i Z.one) in
        let admitted =
          match r.filter with
          | None -> Some true
          | Some c -> Constant.truth report (Env.add v.it { Env.value; span = v.at; used = false } env) c
        in
        let*? admitted = admitted in
        from (Z.succ i) (if admitted then value :: found else found)
    in
    from low []

(* The ranges of one [for], the first outermost. *)
let scopes report env (over : Ast.range list) =
  let count = ref 0 in
  let rec go env found = function
    | [] ->
      incr count;
      Some (env :: found)
    | (r : Ast.range) :: rest ->
      let*? values = numbers report env r.index r.bounds in
      let one found value =
        let*? found = found in
        if !count >= Limits.items then begin
          Report.error report Scc_base.Code.too_deep r.index.at "this `for` names more than %d velocities"
            Limits.items;
          None
        end
        else go (Env.add r.index.it { Env.value; span = r.index.at; used = false } env) found rest
      in
      List.fold_left one (Some found) values
  in
  Option.map List.rev (go env [] over)
