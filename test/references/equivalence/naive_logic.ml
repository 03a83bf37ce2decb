type t =
  | True
  | Not of t
  | And of t list
  | Now of string * t
  | Weakly of string * t
  | Until of t * string * t

let parse s =
  let at = ref 0 in
  let looking_at word =
    !at + String.length word <= String.length s && String.sub s !at (String.length word) = word
  in
  let skip word =
    if looking_at word then begin
      at := !at + String.length word;
      true
    end
    else false
  in
  let expect word = if not (skip word) then failwith (Printf.sprintf "no `%s` at %d of %s" word !at s) in
  let word () =
    let start = !at in
    while !at < String.length s && s.[!at] >= 'a' && s.[!at] <= 'z' do
      incr at
    done;
    String.sub s start (!at - start)
  in
  let rec formula () =
    if skip "true" then True
    else if skip "false" then Not True
    else if skip "not " then Not (formula ())
    else if skip "<<" then modal ">>" (fun a f -> Weakly (a, f))
    else if skip "[[" then modal "]]" (fun a f -> Not (Weakly (a, Not f)))
    else if skip "<" then modal ">" (fun a f -> Now (a, f))
    else if skip "[" then modal "]" (fun a f -> Not (Now (a, Not f)))
    else begin
      expect "(";
      let first = formula () in
      let result =
        if skip " until <" then
          let a = word () in
          expect ">";
          Until (first, a, formula ())
        else if skip " until " then Until (first, "tau", formula ())
        else
          let rec more acc = if skip " and " then more (formula () :: acc) else List.rev acc in
          And (more [ first ])
      in
      expect ")";
      result
    end
  and modal close f =
    let a = word () in
    expect close;
    f a (formula ())
  in
  let f = formula () in
  if !at < String.length s then failwith ("more than a formula: " ^ s);
  f

let rec holds g f s =
  let edges = Naive.edges g in
  let by a s = List.filter_map (fun (x, l, y) -> if x = s && l = a then Some y else None) edges in
  let rec silent set =
    let wider = List.sort_uniq compare (set @ List.concat_map (by "tau") set) in
    if wider = set then set else silent wider
  in
  match f with
  | True -> true
  | Not f -> not (holds g f s)
  | And list -> List.for_all (fun f -> holds g f s) list
  | Now (a, f) -> List.exists (holds g f) (by a s)
  | Weakly ("tau", f) -> List.exists (holds g f) (silent [ s ])
  | Weakly (a, f) ->
    List.exists (holds g f) (silent (List.sort_uniq compare (List.concat_map (by a) (silent [ s ]))))
  | Until (phi, a, psi) ->
    (* the least fixpoint, by as many rounds as there are states *)
    let n = (g : Scc_equivalence.Graph.t).size in
    let now s = if a = "tau" then holds g psi s else holds g phi s && List.exists (holds g psi) (by a s) in
    let base = Array.init n now in
    let phis = Array.init n (holds g phi) in
    for _ = 1 to n do
      for s = 0 to n - 1 do
        if phis.(s) && List.exists (fun t -> base.(t)) (by "tau" s) then base.(s) <- true
      done
    done;
    base.(s)
