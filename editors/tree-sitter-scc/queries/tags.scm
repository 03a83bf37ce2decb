; What a text declares, and what it refers to, for lists of symbols.
(shape_declaration name: (name) @name) @definition.class
(compound_declaration name: (name) @name) @definition.class
(behaviour_declaration name: (name) @name) @definition.function
(process_declaration name: (name) @name) @definition.object
(fixed_declaration name: (name) @name) @definition.object
(param_declaration name: (name) @name) @definition.constant
(let_declaration name: (name) @name) @definition.constant
(check_declaration name: (name) @name) @definition.method

(template_name (name) @name) @reference.class
(behaviour_name (name) @name) @reference.call
