// SPDX-License-Identifier: MIT
#include "coupler_lib/base/box_grid.hpp"
#include "coupler_lib/base/hdf5_reader.hpp"
#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/setup/water_body.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

constexpr double too_close = 0.1; // [particle sizes] two particles of a file may not be nearer
constexpr double certain = 0.4;   // [particle sizes] nearer than this to a particle is inside

/// The datasets of one group; vectors have two numbers in 2D or, as the solver writes them, always three.
template<int D> class ParticleTable {
public:
    explicit ParticleTable(const WaterConfig& water)
        : file_(water.file), group_(water.group), name_("the particles of '" + water.file + "', group " + group_)
    {
        if (group_.empty() || group_.back() != '/') group_ += '/';
        points_ = rows("points", 0);
        volume_ = rows("volume", 1);
        base::require_input(points_.rows > 0, name_, ": there are none");
    }

    std::vector<WaterPoint<D>> points() const
    {
        std::vector<WaterPoint<D>> all(points_.rows);
        const auto velocity = optional("velocity", 0), density = optional("density", 1);
        for (std::size_t k = 0; k < all.size(); ++k) {
            all[k].position = vector(points_, k);
            all[k].volume = volume_.at(k, 0);
            if (velocity) all[k].velocity = vector(*velocity, k);
            if (density) all[k].density = density->at(k, 0);
            check(all[k], k);
        }
        return all;
    }

    const std::string& name() const { return name_; }

private:
    /// \param columns numbers in a row; 0: a vector.
    base::Hdf5Rows rows(const std::string& dataset, std::size_t columns) const
    {
        base::Hdf5Rows found = file_.rows(group_ + dataset);
        const bool fits = columns > 0 ? found.columns == columns : found.columns == D || found.columns == 3;
        base::require_input(fits, name_, ": '", dataset, "' has ", found.columns, " numbers in a row, ",
                            columns > 0 ? columns : std::size_t{D}, " are needed");
        base::require_input(points_.rows == 0 || found.rows == points_.rows, name_, ": '", dataset, "' has ",
                            found.rows, " rows, 'points' has ", points_.rows);
        return found;
    }

    std::optional<base::Hdf5Rows> optional(const std::string& dataset, std::size_t columns) const
    {
        if (!file_.has(group_ + dataset)) return std::nullopt;
        return rows(dataset, columns);
    }

    static Vec<D> vector(const base::Hdf5Rows& rows, std::size_t k)
    {
        Vec<D> x;
        for (int d = 0; d < D; ++d) x[d] = rows.at(k, static_cast<std::size_t>(d));
        return x;
    }

    void check(const WaterPoint<D>& point, std::size_t k) const
    {
        const bool numbers = point.position.allFinite() && (!point.velocity || point.velocity->allFinite());
        base::require_input(numbers, name_, ": row ", k, " holds something that is not a number");
        base::require_input(point.volume > 0.0 && std::isfinite(point.volume), name_, ": row ", k, " has the volume ",
                            point.volume, ", not above zero");
        base::require_input(!point.density || (*point.density > 0.0 && std::isfinite(*point.density)), name_, ": row ",
                            k, " has the density ", point.density.value_or(0.0), ", not above zero");
    }

    base::Hdf5Reader file_;
    std::string group_, name_;
    base::Hdf5Rows points_, volume_;
};

template<int D> class FileWater final : public ListedWater<D> {
public:
    FileWater(std::vector<WaterPoint<D>> points, const std::string& name)
        : ListedWater<D>(std::move(points)), grid_(size_of_largest())
    {
        for (std::size_t k = 0; k < this->points_.size(); ++k) {
            const WaterPoint<D>& point = this->points_[k];
            base::Box<D> reach;
            reach.include(point.position);
            grid_.add(static_cast<int>(k), reach.widened(certain * size(point)));
        }
        grid_.build();
        for (std::size_t k = 0; k < this->points_.size(); ++k) {
            const int other = nearest_within(this->points_[k].position, too_close, static_cast<int>(k));
            base::require_input(other < 0, name, ": rows ", k, " and ", other, " lie on top of each other");
        }
    }

    double top(const Vec<D>& up) const override
    {
        double highest = -std::numeric_limits<double>::infinity();
        for (const auto& point : this->points_) highest = std::max(highest, point.position.dot(up) + 0.5 * size(point));
        return highest;
    }

    bool contains(const Vec<D>& x) const override { return nearest_within(x, certain, -1) >= 0; }

private:
    static double size(const WaterPoint<D>& point) { return std::pow(point.volume, 1.0 / D); }

    double size_of_largest() const
    {
        double largest = 0.0;
        for (const auto& point : this->points_) largest = std::max(largest, size(point));
        return largest;
    }

    /// A particle nearer to x than `reach` of its size, other than number `except`; -1 if there is none.
    int nearest_within(const Vec<D>& x, double reach, int except) const
    {
        for (const int k : grid_.near(x)) {
            const WaterPoint<D>& point = this->points_[static_cast<std::size_t>(k)];
            if (k != except && (point.position - x).norm() < reach * size(point)) return k;
        }
        return -1;
    }

    base::BoxGrid<D> grid_;
};

} // namespace

template<int D> std::unique_ptr<WaterBody<D>> read_particles(const WaterConfig& water)
{
    const ParticleTable<D> table(water);
    return std::make_unique<FileWater<D>>(table.points(), table.name());
}

template std::unique_ptr<WaterBody<2>> read_particles(const WaterConfig&);
template std::unique_ptr<WaterBody<3>> read_particles(const WaterConfig&);

} // namespace sph
