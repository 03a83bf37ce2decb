module Make (Key : Hashtbl.HashedType) = struct
  module Table = Hashtbl.Make (Key)

  type t = { numbers : int Table.t; keys : Key.t Growable.t }

  let create () = { numbers = Table.create 64; keys = Growable.create () }
  let size t = Growable.length t.keys
  let get t i = Growable.get t.keys i

  let number t key =
    match Table.find_opt t.numbers key with
    | Some i -> i
    | None ->
      Scc_base.Critical.run (fun () ->
          let i = size t in
          Growable.push t.keys key;
          Table.add t.numbers key i;
          i)

  let keys t = List.init (size t) (get t)
end
