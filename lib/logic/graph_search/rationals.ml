open Scc_data
open Scc_exact

module Table = Hashtbl.Make (struct
    type t = Rat.t

    let equal = Rat.equal
    let hash = Rat.hash
  end)

type t = { numbers : int Table.t; values : Rat.t Growable.t }

let intern t r =
  match Table.find_opt t.numbers r with
  | Some i -> i
  | None ->
    Scc_base.Critical.run (fun () ->
        let i = Growable.length t.values in
        Growable.push t.values r;
        Table.add t.numbers r i;
        i)

let create () =
  let t = { numbers = Table.create 16; values = Growable.create () } in
  ignore (intern t Rat.zero);
  t

let get t i = Growable.get t.values i
