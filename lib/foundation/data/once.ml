module Make (Key : Hashtbl.HashedType) = struct
  module Table = Hashtbl.Make (Key)

  type 'a t = { make : Key.t -> 'a; made : 'a Table.t }

  let create make = { make; made = Table.create 16 }

  let find t key =
    match Table.find_opt t.made key with
    | Some value -> value
    | None ->
      let value = t.make key in
      Table.add t.made key value;
      value
end
